// grid.cpp: positions of cells and faces, whatever their order, with the ghosts of the model left
// out.
#include "readers/cf_les/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "readers/cf_les/options.h"
#include "readers/les/levels.h"

namespace cf {
namespace {

constexpr std::array kAxisNames{"x", "y", "z"};

/// Positions in metres, as stored.
std::vector<double> metresOf(const TiledFile& file, const nc::NcVariable& variable,
                             std::size_t axis, const Model& model) {
    const std::string unit = variable.units.empty() ? model.lengthUnit : variable.units;
    const auto toM = shared::conversion(unit, "m");
    if (!toM) {
        throw nc::Failure{fmt::format("the unit of coordinate {} is no length", variable.name),
                          fmt::format("\"{}\"", variable.units), "m or km",
                          axis == 2
                              ? "levels of pressure or by number have no heights: add these to the "
                                "file as the coordinate, in m"
                              : "remap output on latitude and longitude to an even grid in "
                                "metres"};
    }
    std::vector<double> values = file.joined(variable, axis);
    for (double& value : values) value = (*toM)(value);
    return values;
}

/// Rounds to the six digits that single precision keeps of a step of positions.
double rounded(double stepM) {
    const double scale = std::pow(10.0, 5.0 - std::floor(std::log10(stepM)));
    return std::round(stepM * scale) / scale;
}

/// Faces around the centres: of the stored faces the nearest on either side, at the ends mirrored
/// where one is missing; none if they do not fit.
std::vector<double> facesAround(const std::vector<double>& centres, std::vector<double> faces) {
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::vector<double> around;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const double centre = centres[i];
        const auto above = std::ranges::upper_bound(faces, centre);
        if (around.empty()) {
            const bool below = above != faces.begin() && *(above - 1) < centre;
            if (!below && above == faces.end()) return {};
            around.push_back(below ? *(above - 1) : 2.0 * centre - *above);
        } else if (above == faces.begin() || *(above - 1) != around.back()) {
            return {};
        }
        const bool end = above == faces.end() && i + 1 == centres.size();
        if (above == faces.end() && !end) return {};
        around.push_back(end ? 2.0 * centre - around.back() : *above);
    }
    return around;
}

class GridFinder {
  public:
    GridFinder(const FileSet& files, const Model& model, std::vector<std::string>& notes)
        : files_(files), model_(model), notes_(notes) {}
    Grid find();

  private:
    void findDimensions();
    void dropHalo();
    /// Centres of the stored cells; none if the file does not give their positions.
    std::vector<double> centresOf(std::size_t axis);
    void findColumns(std::size_t axis);
    void findLevels();
    std::vector<double> statedFaces(std::size_t axis, const std::vector<double>& centres) const;

    const FileSet& files_;
    const Model& model_;
    std::vector<std::string>& notes_;
    Grid grid_;
};

void GridFinder::findDimensions() {
    const auto water = std::ranges::find_if(files_.variables(), [](const Stored& each) {
        return each.name != nullptr && each.layout.onCells() &&
               (each.name->meaning == Meaning::hydrometeor ||
                each.name->meaning == Meaning::cloudCondensate ||
                each.name->meaning == Meaning::precipitation);
    });
    if (water == files_.variables().end()) {
        std::string known;
        for (const Name& name : model_.names) {
            if (name.meaning == Meaning::hydrometeor)
                known += (known.empty() ? "" : ", ") + name.name;
        }
        throw nc::Failure{
            fmt::format("is output of {} without hydrometeors on its grid", model_.title),
            "dimensions " + nc::listOf(files_.main().dimensions()),
            known.empty() ? "variables with standard names of hydrometeors" : "one of " + known,
            "open the files with the 3-D fields of cloud water, rain and ice"};
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const nc::NcDimension& dimension = water->variable->axes[*water->layout.axis[axis]];
        grid_.dimension[axis] = dimension.name;
        grid_.aliases[axis] = model_.axes[axis].cells;
        grid_.stored[axis] = files_.file(water->file).lengthOf(axis, false, dimension.length);
        if (grid_.stored[axis] > kMostCells) {
            throw nc::Failure{fmt::format("dimension {} is too long", dimension.name),
                              fmt::format("{} cells", grid_.stored[axis]),
                              {},
                              {}};
        }
    }
    grid_.size = grid_.stored;
}

/// Columns outside the domain, whose number a variable or an attribute states.
void GridFinder::dropHalo() {
    if (model_.halo.empty()) return;
    double columns = files_.main().number(model_.halo.c_str()).value_or(0.0);
    const nc::NcVariable* variable = named(files_.main(), model_.halo);
    if (variable != nullptr && variable->number && variable->axes.empty()) {
        columns = files_.main().readDoubles(*variable, {}, {}).front();
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto stored = static_cast<double>(grid_.stored[axis]);
        if (!(columns >= 1.0 && 2.0 * columns < stored)) continue;
        grid_.begin[axis] = static_cast<std::size_t>(columns);
        grid_.size[axis] -= 2 * grid_.begin[axis];
    }
    if (grid_.size != grid_.stored) {
        notes_.push_back(fmt::format("{} columns on every side are no part of the domain ({}).",
                                     columns, model_.halo));
    }
}

std::vector<double> GridFinder::centresOf(std::size_t axis) {
    const nc::NcVariable* variable =
        Axes::positions(files_.main(), model_, axis, grid_.dimension[axis]);
    if (variable == nullptr) return {};
    std::vector<double> centres = metresOf(files_.tiles(), *variable, axis, model_);
    if (centres.size() != grid_.stored[axis]) {
        throw nc::Failure{fmt::format("coordinate {} does not fit its dimension", variable->name),
                          fmt::format("{} positions", centres.size()),
                          fmt::format("{}", grid_.stored[axis]),
                          {}};
    }
    grid_.flip[axis] = centres.size() > 1 && centres.back() < centres.front();
    return centres;
}

std::vector<double> GridFinder::statedFaces(std::size_t axis,
                                            const std::vector<double>& centres) const {
    const nc::NcVariable* variable = Axes::faces(files_.main(), model_, axis);
    if (variable == nullptr) return {};
    return facesAround(centres, metresOf(files_.tiles(), *variable, axis, model_));
}

void GridFinder::findColumns(std::size_t axis) {
    std::vector<double> centres = centresOf(axis);
    if (centres.empty()) {
        grid_.spacingM[axis] = statedSpacing(files_.main(), axis).value_or(0.0);
        if (grid_.spacingM[axis] > 0.0) return;
        throw nc::Failure{fmt::format("does not say where its cells lie in {}", kAxisNames[axis]),
                          fmt::format("no variable of positions along {}", grid_.dimension[axis]),
                          fmt::format("a coordinate {} in m", grid_.dimension[axis]),
                          fmt::format("add the coordinate, or a global attribute d{} with the "
                                      "width of cells in m",
                                      kAxisNames[axis])};
    }
    if (grid_.flip[axis]) std::ranges::reverse(centres);
    const std::size_t first = grid_.begin[axis];
    centres = {centres.begin() + static_cast<std::ptrdiff_t>(first),
               centres.begin() + static_cast<std::ptrdiff_t>(first + grid_.size[axis])};
    if (const auto step = les::evenStep(centres)) {
        grid_.spacingM[axis] =
            *step > 0.0 ? rounded(*step) : statedSpacing(files_.main(), axis).value_or(0.0);
        grid_.cornerM[axis] = centres.front() - 0.5 * grid_.spacingM[axis];
        return;
    }
    std::vector<double> faces = statedFaces(axis, centres);
    if (faces.empty()) {
        faces = les::facesOf(grid_.dimension[axis], centres);
        grid_.cornerM[axis] = centres.front() - 0.5 * faces[1];
    } else {
        grid_.cornerM[axis] = faces.front();
        les::startAtZero("faces of " + grid_.dimension[axis], faces);
    }
    double least = faces[1];
    for (std::size_t i = 1; i < faces.size(); ++i) least = std::min(least, faces[i] - faces[i - 1]);
    grid_.spacingM[axis] = rounded(least);
    grid_.edgesM[axis] = std::move(faces);
}

void GridFinder::findLevels() {
    std::vector<double> centres = centresOf(2);
    if (centres.empty()) {
        throw nc::Failure{"does not say how high its levels are",
                          fmt::format("no variable of positions along {}", grid_.dimension[2]),
                          fmt::format("a coordinate {} in m", grid_.dimension[2]),
                          "add the heights of the levels to the file as that coordinate"};
    }
    if (grid_.flip[2]) std::ranges::reverse(centres);
    const auto ghosts = static_cast<std::size_t>(std::ranges::count_if(
        centres, [&](double centre) { return model_.ghostLevels && !(centre > 0.0); }));
    const std::size_t above = model_.halo.empty() ? 0 : 1;  // as many as below
    if (centres.size() <= ghosts + above) {
        throw nc::Failure{
            "no level lies above the ground",
            fmt::format("{} levels, the highest at {:g} m", centres.size(), centres.back()),
            "heights in m",
            {}};
    }
    centres.erase(centres.begin(), centres.begin() + static_cast<std::ptrdiff_t>(ghosts));
    centres.resize(centres.size() - above);
    grid_.begin[2] = grid_.flip[2] ? above : ghosts;
    grid_.size[2] = centres.size();
    if (ghosts + above > 0) {
        notes_.push_back(fmt::format("{} of {} levels are left out: {} at or below the ground{}.",
                                     ghosts + above, grid_.stored[2], ghosts,
                                     above > 0 ? " and one above the domain" : ""));
    }
    grid_.interfacesM = statedFaces(2, centres);
    if (grid_.interfacesM.empty()) grid_.interfacesM = les::interfacesOf(centres);
    for (std::size_t k = 1; k < grid_.interfacesM.size(); ++k) {
        if (grid_.interfacesM[k] > grid_.interfacesM[k - 1]) continue;
        throw nc::Failure{
            fmt::format("the levels of {} do not increase", grid_.dimension[2]),
            fmt::format("{:g} m after {:g} m", grid_.interfacesM[k], grid_.interfacesM[k - 1]),
            {},
            {}};
    }
}

Grid GridFinder::find() {
    findDimensions();
    dropHalo();
    findColumns(0);
    findColumns(1);
    findLevels();
    for (const std::size_t axis : {0U, 1U}) {
        // A two-dimensional run has a single cell in one direction: as wide as the others.
        if (!(grid_.spacingM[axis] > 0.0)) grid_.spacingM[axis] = grid_.spacingM[1 - axis];
    }
    if (!(grid_.spacingM[0] > 0.0)) {
        throw nc::Failure{"the grid has a single column", {}, "at least two cells in x or y", {}};
    }
    return std::move(grid_);
}

}  // namespace

bool Grid::holds(const Stored& each) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!each.layout.axis[axis]) continue;
        if (each.layout.face[axis]) return false;
        const nc::NcDimension& own = each.variable->axes[*each.layout.axis[axis]];
        const bool alias = std::ranges::find(aliases[axis], own.name) != aliases[axis].end();
        if (own.name != dimension[axis] && !alias) return false;
    }
    return true;
}

les::Box Grid::storedBox(const les::Box& box, const Layout& layout) const {
    les::Box result = box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!layout.axis[axis]) continue;
        const std::size_t lower = flip[axis] ? size[axis] - box.upper[axis] : box.lower[axis];
        result.lower[axis] = begin[axis] + lower;
        result.upper[axis] = result.lower[axis] + box.length(axis);
    }
    return result;
}

Grid gridOf(const FileSet& files, const Model& model, std::vector<std::string>& notes) {
    return GridFinder(files, model, notes).find();
}

void turn(std::span<float> values, const les::Box& box, const std::array<bool, 3>& flip,
          const Layout& layout) {
    const std::size_t width = box.length(0);
    const std::size_t plane = box.plane();
    const auto place = [&](std::size_t at) {
        return values.begin() + static_cast<std::ptrdiff_t>(at);
    };
    if (flip[0] && layout.axis[0]) {
        for (std::size_t at = 0; at < values.size(); at += width) {
            std::reverse(place(at), place(at + width));
        }
    }
    if (flip[1] && layout.axis[1]) {
        for (std::size_t level = 0; level < values.size(); level += plane) {
            for (std::size_t y = 0; y < box.length(1) / 2; ++y) {
                std::swap_ranges(place(level + y * width), place(level + (y + 1) * width),
                                 place(level + (box.length(1) - 1 - y) * width));
            }
        }
    }
    if (flip[2] && layout.axis[2]) {
        for (std::size_t z = 0; z < box.length(2) / 2; ++z) {
            std::swap_ranges(place(z * plane), place((z + 1) * plane),
                             place((box.length(2) - 1 - z) * plane));
        }
    }
}

}  // namespace cf
