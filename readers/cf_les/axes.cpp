// axes.cpp: roles of dimensions and variables, by name and attributes.
#include "readers/cf_les/axes.h"

#include <algorithm>

#include "readers/les/text.h"
#include "readers/shared/units.h"

namespace cf {
namespace {

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

/// The axis that a coordinate states by the attributes of CF.
std::optional<std::size_t> statedAxis(const nc::NcFile& file, const nc::NcVariable& coordinate) {
    if (coordinate.units.find(" since ") != std::string::npos) return Place::kTime;
    const std::string axis = file.text(coordinate, "axis").value_or("");
    constexpr std::string_view kAxes = "XYZT";
    if (axis.size() == 1 && kAxes.find(axis) != std::string_view::npos) return kAxes.find(axis);
    if (coordinate.standardName == "projection_x_coordinate") return 0;
    if (coordinate.standardName == "projection_y_coordinate") return 1;
    if (coordinate.standardName == "time") return Place::kTime;
    const bool height = coordinate.standardName == "height" ||
                        coordinate.standardName == "altitude" ||
                        file.text(coordinate, "positive").has_value();
    if (height) return 2;
    return {};
}

std::optional<Place> placeOf(const nc::NcFile& file, const Model& model,
                             const nc::NcDimension& dimension) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (contains(model.axes[axis].cells, dimension.name)) return Place{axis, false};
        if (contains(model.axes[axis].faces, dimension.name)) return Place{axis, true};
    }
    const std::string& name = dimension.name;
    if (contains(model.times, name) || name == "time" || name == "Time" ||
        name.starts_with("time_series")) {
        return Place{Place::kTime, false};
    }
    const nc::NcVariable* coordinate = named(file, name);
    if (coordinate == nullptr || !coordinate->number || coordinate->axes.size() != 1) return {};
    const auto axis = statedAxis(file, *coordinate);
    if (!axis) return {};
    return Place{*axis, false};
}

bool isAlong(const nc::NcVariable* variable, const std::string& dimension) {
    return variable != nullptr && variable->number && variable->axes.size() == 1 &&
           (dimension.empty() || variable->axes.front().name == dimension);
}

bool fits(const nc::NcFile& file, const Mark& mark) {
    const auto hasDimension = [&](const std::string& name) {
        return file.dimension(name) != nullptr;
    };
    const auto hasVariable = [&](const std::string& name) { return named(file, name) != nullptr; };
    if (!std::ranges::all_of(mark.dimensions, hasDimension)) return false;
    if (!mark.variables.empty() && !std::ranges::any_of(mark.variables, hasVariable)) return false;
    if (mark.attribute.empty()) return true;
    const auto text = file.text(mark.attribute.c_str());
    return text && text->find(mark.text) != std::string::npos;
}

}  // namespace

Axes::Axes(const nc::NcFile& file, const Model& model) {
    for (const nc::NcDimension& dimension : file.dimensions()) {
        if (const auto place = placeOf(file, model, dimension)) places_[dimension.name] = *place;
    }
}

std::optional<Layout> Axes::layoutOf(const nc::NcVariable& variable) const {
    Layout layout;
    for (std::size_t i = 0; i < variable.axes.size(); ++i) {
        const nc::NcDimension& dimension = variable.axes[i];
        const auto place = places_.find(dimension.name);
        if (place == places_.end()) {
            if (dimension.length == 1) continue;
            return {};
        }
        if (dimension.length < 1 || dimension.length > kMostCells) return {};
        auto& position =
            place->second.axis == Place::kTime ? layout.time : layout.axis[place->second.axis];
        if (position) return {};
        position = i;
        if (place->second.axis < 3) layout.face[place->second.axis] = place->second.face;
    }
    return layout;
}

const nc::NcVariable* Axes::positions(const nc::NcFile& file, const Model& model, std::size_t axis,
                                      const std::string& dimension) {
    for (const std::string& name : model.axes[axis].cellPositions) {
        const nc::NcVariable* variable = named(file, name);
        if (isAlong(variable, dimension)) return variable;
        // Of two names of one axis, as z and zn, the positions may lie along the other.
        const nc::NcDimension* own = file.dimension(dimension);
        if (isAlong(variable, "") && own != nullptr &&
            contains(model.axes[axis].cells, variable->axes.front().name) &&
            variable->axes.front().length == own->length) {
            return variable;
        }
    }
    const nc::NcVariable* variable = named(file, dimension);
    return isAlong(variable, dimension) ? variable : nullptr;
}

const nc::NcVariable* Axes::faces(const nc::NcFile& file, const Model& model, std::size_t axis) {
    for (const std::string& name : model.axes[axis].facePositions) {
        const nc::NcVariable* variable = named(file, name);
        if (isAlong(variable, "") && variable->axes.front().length <= kMostCells) return variable;
    }
    return nullptr;
}

bool isOf(const nc::NcFile& file, const Model& model) {
    return std::ranges::any_of(model.marks, [&](const Mark& mark) { return fits(file, mark); });
}

const nc::NcVariable* named(const nc::NcFile& file, std::string_view name) {
    const auto found = std::ranges::find(file.variables(), name, &nc::NcVariable::name);
    return found == file.variables().end() ? nullptr : &*found;
}

const Name* nameOf(const nc::NcFile& file, const nc::NcVariable& variable, const Model& model) {
    if (!variable.number) return nullptr;
    const auto inRow = std::ranges::find(model.names, variable.name, &Name::name);
    // A coordinate of CF may have the standard name of a field: the altitude of levels.
    const bool coordinate = variable.axes.size() < 2 && file.dimension(variable.name) != nullptr;
    if (!variable.standardName.empty() && !coordinate) {
        const auto& table = standardNames();
        const auto found = std::ranges::find(table, variable.standardName, &Name::standardName);
        if (found != table.end()) return &*found;
    }
    return inRow == model.names.end() ? nullptr : &*inRow;
}

bool isWater(const nc::NcFile& file, const nc::NcVariable& variable, const Model& model,
             const Axes& axes) {
    const Name* name = nameOf(file, variable, model);
    const bool water = name != nullptr && (name->meaning == Meaning::hydrometeor ||
                                           name->meaning == Meaning::cloudCondensate ||
                                           name->meaning == Meaning::precipitation);
    const auto layout = water ? axes.layoutOf(variable) : std::nullopt;
    return layout && layout->onCells();
}

}  // namespace cf
