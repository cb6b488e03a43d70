// dataset_info.cpp: looking for variables, and positions of cells.
#include "core/plugin/dataset_info.h"

#include <algorithm>

namespace neph {

double DatasetInfo::edgeM(int axis, int face) const {
    const std::vector<double>& edges = edgesM[static_cast<std::size_t>(axis)];
    return edges.empty() ? spacingM[axis] * face : edges[static_cast<std::size_t>(face)];
}

glm::dvec2 DatasetInfo::extentM() const {
    return {edgeM(0, size.x), edgeM(1, size.y)};
}

bool DatasetInfo::moves() const {
    return std::ranges::any_of(
        times, [&](const TimeInfo& time) { return time.gridOffsetM != times.front().gridOffsetM; });
}

const VariableInfo* DatasetInfo::find(std::string_view name) const {
    const auto found = std::ranges::find(variables, name, &VariableInfo::name);
    return found == variables.end() ? nullptr : &*found;
}

const VariableInfo* DatasetInfo::find(VariableRole role, std::optional<Species> species) const {
    const auto found = std::ranges::find_if(variables, [&](const VariableInfo& variable) {
        return variable.role == role && variable.species == species;
    });
    return found == variables.end() ? nullptr : &*found;
}

}  // namespace neph
