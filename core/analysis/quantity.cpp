// quantity.cpp: which variables a quantity needs.
#include "core/analysis/quantity.h"

#include <fmt/format.h>

#include <algorithm>

namespace neph {
namespace {

std::string_view nameOf(VariableRole role) {
    switch (role) {
        case VariableRole::xWind:
            return "wind along x";
        case VariableRole::yWind:
            return "wind along y";
        case VariableRole::upwardWind:
            return "upward wind";
        case VariableRole::airPressure:
            return "pressure";
        case VariableRole::airTemperature:
            return "temperature";
        case VariableRole::waterVapour:
            return "water vapour";
        default:
            return "such variable";
    }
}

}  // namespace

std::optional<Quantity> quantityOf(std::string_view id) {
    const auto row = std::ranges::find(kQuantities, id, &QuantityInfo::id);
    if (row == kQuantities.end()) return {};
    return row->quantity;
}

std::string quantityIds() {
    std::string ids;
    for (const QuantityInfo& row : kQuantities) {
        ids += fmt::format("{}{}", ids.empty() ? "" : ", ", row.id);
    }
    return ids;
}

std::vector<VariableRole> rolesOf(Quantity quantity) {
    using enum VariableRole;
    switch (quantity) {
        case Quantity::upwardWind:
            return {upwardWind};
        case Quantity::xWind:
            return {xWind};
        case Quantity::yWind:
            return {yWind};
        case Quantity::windSpeed:
        case Quantity::vorticity:
            return {xWind, yWind};
        case Quantity::vapour:
            return {waterVapour};
        case Quantity::temperature:
            return {airTemperature};
        case Quantity::theta:
            return {airPressure, airTemperature};
        case Quantity::thetaE:
        case Quantity::humidity:
            return {airPressure, airTemperature, waterVapour};
        case Quantity::pressure:
            return {airPressure};
        default:
            return {};
    }
}

const VariableInfo* reflectivityOf(const DatasetInfo& info) {
    for (const VariableInfo& variable : info.variables) {
        const bool named = variable.standardName == "equivalent_reflectivity_factor" ||
                           variable.name == "REFL_10CM" || variable.name == "dbz";
        if (named && variable.size == info.size) return &variable;
    }
    return nullptr;
}

std::string lackOf(Quantity quantity, const DatasetInfo& info) {
    const auto has = [&](int species) {
        return info.find(VariableRole::mixingRatio, static_cast<Species>(species)) != nullptr;
    };
    const int index = static_cast<int>(quantity);
    if (index < kSpeciesCount && !has(index)) {
        return fmt::format("they have no {}", neph::info(static_cast<Species>(index)).id);
    }
    if (quantity == Quantity::condensate) {
        bool any = false;
        for (int s = 0; s < kSpeciesCount; ++s) any = any || has(s);
        if (!any) return "they have no hydrometeor";
    }
    if (quantity == Quantity::reflectivity && reflectivityOf(info) == nullptr) {
        return "they have no reflectivity of the model's own (REFL_10CM, dbz)";
    }
    for (const VariableRole role : rolesOf(quantity)) {
        if (info.find(role) == nullptr) return fmt::format("they have no {}", nameOf(role));
    }
    return {};
}

}  // namespace neph
