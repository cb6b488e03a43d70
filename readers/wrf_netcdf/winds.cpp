// winds.cpp: components by WRF's names, those of restart files, and CF standard names.
#include "readers/wrf_netcdf/winds.h"

#include <fmt/format.h>

namespace wrf {
namespace {

/// A component of the wind and the names that it is stored by, the first of which is taken.
struct Component {
    NephRole role;
    const char* name;  ///< in the cells
    const char* standardName;
    int axis;
    std::array<const char*, 5> stored;
};
// U_2 and the like are of restart files, ua of processed ones.
constexpr std::array kComponents{
    Component{NEPH_ROLE_X_WIND, "wind_x", "x_wind", 0, {"U", "U_2", "x_wind", "ua", "umet"}},
    Component{NEPH_ROLE_Y_WIND, "wind_y", "y_wind", 1, {"V", "V_2", "y_wind", "va", "vmet"}},
    Component{NEPH_ROLE_UPWARD_WIND,
              "wind_z",
              "upward_air_velocity",
              2,
              {"W", "W_2", "upward_air_velocity", "wa", "w"}},
};

}  // namespace

int facesAxisOf(const Tiles& tiles, const NcVariable& variable) {
    const auto shape = tiles.shapeOf(variable);
    if (!shape || shape->flat) return -1;
    for (int axis = 0; axis < 3; ++axis) {
        if (shape->staggered[static_cast<std::size_t>(axis)]) return axis;
    }
    return -1;
}

std::vector<Field> findWinds(const Tiles& tiles, UnitNotes& unitNotes,
                             std::vector<std::string>& notes) {
    std::vector<Field> fields;
    for (const Component& component : kComponents) {
        for (const char* stored : component.stored) {
            const NcVariable* variable = tiles.first().variable(stored);
            if (variable == nullptr) variable = tiles.first().variableOfStandardName(stored);
            if (variable == nullptr || !variable->number) continue;
            const auto shape = tiles.shapeOf(*variable);
            const int axis = facesAxisOf(tiles, *variable);
            if (!shape || shape->flat || !(shape->onCells() || axis == component.axis)) continue;
            const auto term = termOf(*variable, "m s-1", unitNotes);
            if (!term) {
                notes.push_back(
                    fmt::format("{} is not used: its units \"{}\" do not convert to m s-1.",
                                variable->name, variable->units));
                continue;
            }
            Field field;
            field.role = component.role;
            field.name = shape->onCells() ? variable->name : component.name;
            field.standardName = component.standardName;
            field.units = "m s-1";
            field.description = shape->onCells()
                                    ? variable->description
                                    : fmt::format("{} in the middle of cells", variable->name);
            field.reason = shape->onCells() ? "its name"
                                            : fmt::format(
                                                  "computed: mean of {} on both faces of "
                                                  "each cell",
                                                  variable->name);
            field.source = shape->onCells() ? Source::sum : Source::meanOfFaces;
            field.terms = {*term};
            fields.push_back(std::move(field));
            break;
        }
    }
    return fields;
}

void meansOfFaces(std::span<const float> faces, int axis, const shared::Box& box,
                  std::span<float> cells) {
    std::array<std::size_t, 3> size{box.length(0), box.length(1), box.length(2)};
    std::array<std::size_t, 3> stored = size;
    ++stored[static_cast<std::size_t>(axis)];
    const std::array<std::size_t, 3> strides{1, stored[0], stored[0] * stored[1]};
    const std::size_t next = strides[static_cast<std::size_t>(axis)];
    std::size_t cell = 0;
    for (std::size_t z = 0; z < size[2]; ++z) {
        for (std::size_t y = 0; y < size[1]; ++y) {
            for (std::size_t x = 0; x < size[0]; ++x, ++cell) {
                const std::size_t face = x + y * strides[1] + z * strides[2];
                cells[cell] = 0.5f * (faces[face] + faces[face + next]);
            }
        }
    }
}

}  // namespace wrf
