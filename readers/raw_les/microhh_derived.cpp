// microhh_derived.cpp: values of one cell from those of its fields.
#include "readers/raw_les/microhh_derived.h"

#include <algorithm>
#include <cmath>

namespace les {
namespace {

namespace plugin = neph::plugin;

// MicroHH's constants.h
constexpr double kVaporisation = 2.501e6, kFusion = 3.337e5;  // J/kg
constexpr double kDryGas = 287.04, kHeatCapacity = 1005.0;    // J/(kg K)
constexpr double kReferencePa = 1e5;

std::optional<std::size_t> indexOf(const Contents& contents, std::string_view name) {
    const auto& variables = contents.description.variables;
    const auto found = std::ranges::find(variables, name, &plugin::Variable::name);
    if (found == variables.end()) return {};
    return static_cast<std::size_t>(found - variables.begin());
}

double temperatureOf(std::span<const double> of, std::span<const double> latentHeats) {
    double temperatureK = of[0] * std::pow(of[1] / kReferencePa, kDryGas / kHeatCapacity);
    for (std::size_t i = 0; i < latentHeats.size(); ++i) {
        temperatureK += latentHeats[i] / kHeatCapacity * of[2 + i];
    }
    return temperatureK;
}

/// Of total water and condensate per kg of moist air, per kg of dry air.
double vapourOf(std::span<const double> of) {
    double fraction = of[0];
    for (const double condensate : of.subspan(1)) fraction -= condensate;
    return fraction / (1.0 - of[0]);
}

}  // namespace

void addRainNumber(Contents& contents) {
    const auto number = indexOf(contents, "nr");
    const auto density = contents.find(NEPH_ROLE_DRY_AIR_DENSITY);
    if (!number || !density) return;
    contents.addDerived(
        {"nr/rho", "", "kg-1", "number of rain drops per kg of air", NEPH_ROLE_NUMBER_CONCENTRATION,
         NEPH_SPECIES_RAIN, contents.description.size},
        {{{*number}, {*density}},
         [](std::span<const double> of, std::size_t) { return of[0] / of[1]; }});
}

void addHumidity(Contents& contents) {
    const auto pressure = contents.find(NEPH_ROLE_AIR_PRESSURE);
    const auto heat = indexOf(contents, "thl"), water = indexOf(contents, "qt");
    if (!pressure || !heat || !water) return;
    Derived temperature{{{*heat}, {*pressure}}, {}}, vapour{{{*water}}, {}};
    std::vector<double> latentHeats;
    std::string name = "qt";
    const auto addCondensate = [&](const std::string& field, double latentHeat) {
        const auto index = indexOf(contents, field);
        if (!index) return;
        temperature.inputs.push_back({*index});
        vapour.inputs.push_back({*index});
        latentHeats.push_back(latentHeat);
        name += "-" + field;
    };
    addCondensate("ql", kVaporisation);
    addCondensate("qi", kVaporisation + kFusion);
    temperature.value = [latentHeats](std::span<const double> of, std::size_t) {
        return temperatureOf(of, latentHeats);
    };
    vapour.value = [](std::span<const double> of, std::size_t) { return vapourOf(of); };
    if (const auto reference = contents.find(NEPH_ROLE_AIR_TEMPERATURE)) {
        contents.description.variables[*reference].role = NEPH_ROLE_OTHER;
    }
    const auto& size = contents.description.size;
    contents.addDerived({"air_temperature", "air_temperature", "K", "from thl and condensate",
                         NEPH_ROLE_AIR_TEMPERATURE, NEPH_SPECIES_NONE, size},
                        std::move(temperature));
    contents.addDerived({name, "humidity_mixing_ratio", "kg kg-1", "water vapour",
                         NEPH_ROLE_WATER_VAPOUR, NEPH_SPECIES_NONE, size},
                        std::move(vapour));
}

}  // namespace les
