// dataset_info.cpp: looking for variables.
#include "core/plugin/dataset_info.h"

#include <algorithm>

namespace neph {

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
