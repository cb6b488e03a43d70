// term.cpp: units of stored variables.
#include "readers/wrf_netcdf/term.h"

#include <fmt/format.h>

namespace wrf {

void UnitNotes::addTo(std::vector<std::string>& notes) const {
    if (!without.empty()) {
        notes.push_back(fmt::format("Without the attribute units, those of WRF are assumed: {}.",
                                    joined(without)));
    }
    if (!converted.empty()) {
        notes.push_back(
            fmt::format("Units are converted as the file states them: {}.", joined(converted)));
    }
}

std::optional<Term> termOf(const NcVariable& variable, std::string_view wanted, UnitNotes& notes) {
    if (variable.units.empty()) {
        notes.without.push_back(variable.name);
        return Term{&variable, {}};
    }
    const auto toSi = shared::conversion(variable.units, wanted);
    if (!toSi) return {};
    if (!toSi->isIdentity()) {
        notes.converted.push_back(
            fmt::format("{} from {} to {}", variable.name, variable.units, wanted));
    }
    return Term{&variable, *toSi};
}

Failure wrongUnit(const NcVariable& variable, std::string_view wanted) {
    return Failure{fmt::format("the units of variable {} cannot be converted", variable.name),
                   fmt::format("\"{}\"", variable.units),
                   fmt::format("what converts to {}", wanted),
                   fmt::format("if the attribute is wrong, state the unit that the values are in: "
                               "ncatted -a units,{},o,c,\"{}\" FILE",
                               variable.name, wanted)};
}

}  // namespace wrf
