// axes.cpp: finds the axes from the first field that every kind of output has.
#include "readers/wrf_netcdf/axes.h"

#include <fmt/format.h>

#include <algorithm>

namespace wrf {
namespace {

constexpr std::size_t kMaxCells = 1U << 20U;  // along one axis; no model comes near

/// Fields that lie on the cells in all output of WRF and its tools.
constexpr std::array kOnCells{"T",
                              "P",
                              "PB",
                              "QVAPOR",
                              "QCLOUD",
                              "QRAIN",
                              "QICE",
                              "QSNOW",
                              "T_2",
                              "THM_2",
                              "TK",
                              "air_pressure",
                              "air_potential_temperature"};

/// WRF's own names, by which another order of axes is noticed.
constexpr std::array<std::string_view, 3> kOwnNames{"west_east", "south_north", "bottom_top"};

bool isTime(const NcFile& file, const std::string& dimension) {
    if (dimension == "Time" || dimension == "time") return true;
    const NcVariable* coordinate = file.variable(dimension);
    return coordinate != nullptr && coordinate->units.find(" since ") != std::string::npos;
}

/// The first field with three axes beside time; null if there is none.
const NcVariable* fieldOnCells(const NcFile& file) {
    for (const char* name : kOnCells) {
        const NcVariable* variable = file.variable(name);
        if (variable == nullptr || !variable->number) continue;
        const std::size_t rank = variable->axes.size();
        const bool timed = rank > 0 && isTime(file, variable->axes.front().name);
        if (rank == 4 || (rank == 3 && !timed)) return variable;
    }
    return nullptr;
}

/// Throws Failure if an axis with one of WRF's own names stands in the place of another.
void requireOrder(const NcVariable& field) {
    const std::size_t rank = field.axes.size();
    for (std::size_t place = 0; place < rank; ++place) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string& name = field.axes[rank - 1 - place].name;
            if (name != kOwnNames[axis] || place == axis) continue;
            throw Failure{fmt::format("the axes of variable {} are in another order", field.name),
                          listOf(field.axes), "Time, bottom_top, south_north, west_east",
                          "ncpdq -a Time,bottom_top,south_north,west_east IN.nc OUT.nc"};
        }
    }
}

/// The dimension of faces along an axis: that of the wind or height there, or one that is named
/// after the dimension of cells. In a tile it may have no more entries than there are cells.
std::string faceOf(const NcFile& file, const Axes& axes, std::size_t axis) {
    constexpr std::array<std::array<const char*, 2>, 3> kStaggered{
        {{"U", "U_2"}, {"V", "V_2"}, {"PH", "PHB"}}};
    const auto fits = [&](const NcDimension& dimension) {
        return dimension.name != axes.centre[axis] &&
               (dimension.length == axes.faces(axis) ||
                (axis < 2 && dimension.length == axes.length[axis]));
    };
    for (const char* name : kStaggered[axis]) {
        const NcVariable* variable = file.variable(name);
        if (variable == nullptr || variable->axes.size() < 3) continue;
        const NcDimension& dimension = variable->axes[variable->axes.size() - 1 - axis];
        if (fits(dimension)) return dimension.name;
    }
    const NcDimension* named = file.dimension(axes.centre[axis] + "_stag");
    return named != nullptr && fits(*named) ? named->name : std::string();
}

}  // namespace

std::optional<Axes> axesOf(const NcFile& file) {
    const NcVariable* field = fieldOnCells(file);
    Axes axes;
    if (field != nullptr) {
        requireOrder(*field);
        const std::size_t rank = field->axes.size();
        if (rank == 4) axes.time = field->axes.front().name;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            axes.centre[axis] = field->axes[rank - 1 - axis].name;
            axes.length[axis] = field->axes[rank - 1 - axis].length;
        }
    } else {
        axes.time = "Time";
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const NcDimension* dimension = file.dimension(kOwnNames[axis]);
            if (dimension == nullptr) return {};
            axes.centre[axis] = dimension->name;
            axes.length[axis] = dimension->length;
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) axes.face[axis] = faceOf(file, axes, axis);
    return axes;
}

std::optional<Shape> shapeOf(const NcVariable& variable, const Axes& axes) {
    Shape shape;
    const auto& own = variable.axes;
    shape.timed = !own.empty() && !axes.time.empty() && own.front().name == axes.time;
    const std::size_t rank = own.size() - (shape.timed ? 1 : 0);
    if (rank < 2 || rank > 3) return {};
    shape.flat = rank == 2;
    bool otherLevels = false;
    for (std::size_t axis = 0; axis < rank; ++axis) {
        const NcDimension& dimension = own[own.size() - 1 - axis];
        if (dimension.length < 1 || dimension.length > kMaxCells) return {};
        shape.size[axis] = dimension.length;
        shape.staggered[axis] = dimension.name == axes.face[axis] && !axes.face[axis].empty();
        if (shape.staggered[axis] || dimension.name == axes.centre[axis]) continue;
        if (axis < 2) return {};
        otherLevels = true;
    }
    // Levels of soil and the like: neither cells nor interfaces.
    if (otherLevels) shape.staggered = {true, true, true};
    return shape;
}

}  // namespace wrf
