// twins.cpp: categories are summed; of two names of the same water the first is used.
#include "readers/les/twins.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "readers/les/names.h"

namespace les {

std::vector<std::string> settleTwins(Contents& contents) {
    std::map<std::pair<NephRole, NephSpecies>, std::vector<std::size_t>> groups;
    auto& variables = contents.description.variables;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        if (variables[i].role != NEPH_ROLE_OTHER) {
            groups[{variables[i].role, variables[i].species}].push_back(i);
        }
    }
    std::vector<std::string> twice;
    for (const auto& [key, members] : groups) {
        if (members.size() < 2) continue;
        const bool amounts =
            key.first == NEPH_ROLE_MIXING_RATIO || key.first == NEPH_ROLE_NUMBER_CONCENTRATION;
        const bool adds =
            std::ranges::all_of(members, [&](std::size_t i) { return addsUp(variables[i].name); });
        if (amounts && adds) {
            contents.addSum(members);
            continue;
        }
        for (std::size_t i = 1; i < members.size(); ++i) {
            neph::plugin::Variable& other = variables[members[i]];
            other.role = NEPH_ROLE_OTHER;
            other.species = NEPH_SPECIES_NONE;
            twice.push_back(fmt::format("{} (like {})", other.name, variables[members[0]].name));
        }
    }
    return twice;
}

}  // namespace les
