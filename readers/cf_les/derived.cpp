// derived.cpp: see the header. docs/readers.md states every rule.
#include "readers/cf_les/derived.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "readers/les/names.h"

namespace cf {
namespace {

namespace plugin = neph::plugin;

/// A derived variable on all cells.
plugin::Variable onCells(const les::Contents& contents, const char* name, const char* standardName,
                         const char* units, const std::string& description, NephRole role,
                         NephSpecies species = NEPH_SPECIES_NONE) {
    plugin::Variable variable{
        name, standardName, units, description, role, species, contents.description.size};
    variable.reason = "computed: " + description;
    return variable;
}

std::string nameAt(const les::Contents& contents, std::size_t index) {
    return contents.description.variables[index].name;
}

void note(les::Contents& contents, std::string text) {
    contents.description.notes.push_back(std::move(text));
}

double sum(std::span<const double> values, std::size_t) {
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
}

void derivePressure(const Meanings& meanings, les::Contents& contents) {
    const auto base = meanings.find(Meaning::basePressure);
    const auto deviation = meanings.find(Meaning::pressureDeviation);
    if (meanings.find(Meaning::pressure) || !base) return;
    std::string description = "pressure of the base state " + nameAt(contents, *base);
    les::Derived derived{{{*base}}, sum};
    if (deviation) {
        description += " and its deviation " + nameAt(contents, *deviation);
        derived.inputs.push_back({*deviation});
    }
    contents.addDerived(onCells(contents, "air_pressure", "air_pressure", "Pa", description,
                                NEPH_ROLE_AIR_PRESSURE),
                        std::move(derived));
}

void deriveTheta(const Meanings& meanings, les::Contents& contents) {
    contents.potentialTemperature = meanings.find(Meaning::theta);
    const auto base = meanings.find(Meaning::baseTheta);
    const auto deviation = meanings.find(Meaning::thetaDeviation);
    if (contents.potentialTemperature || !deviation) return;
    if (!base) {
        note(contents,
             fmt::format("{} is not used: the base state that it deviates from is not in the file.",
                         nameAt(contents, *deviation)));
        return;
    }
    contents.potentialTemperature = contents.sources.size();
    contents.addDerived(
        onCells(contents, "potential_temperature", "air_potential_temperature", "K",
                fmt::format("{} + {}", nameAt(contents, *base), nameAt(contents, *deviation)),
                NEPH_ROLE_OTHER),
        {{{*base}, {*deviation}}, sum});
}

/// T = Π θ_l + (L_v / c_p) q_l, Π = (p / p₀)^(R_d / c_p): exact where θ_l is defined as
/// θ − (L_v / (c_p Π)) q_l, as in DALES (Heus et al. 2010, eq. 5) and MicroHH.
void deriveTemperature(const Model& model, const Meanings& meanings, les::Contents& contents) {
    const auto pressure = contents.find(NEPH_ROLE_AIR_PRESSURE);
    const auto liquid = meanings.find(Meaning::liquidTheta);
    if (contents.find(NEPH_ROLE_AIR_TEMPERATURE) || contents.potentialTemperature || !pressure ||
        !liquid) {
        return;
    }
    les::Derived derived{{{*liquid}, {*pressure}}, {}};
    std::string text = nameAt(contents, *liquid) + " and " + nameAt(contents, *pressure);
    for (std::size_t i = 0; i < contents.description.variables.size(); ++i) {
        const plugin::Variable& variable = contents.description.variables[i];
        const bool cloud =
            variable.role == NEPH_ROLE_MIXING_RATIO && variable.species == NEPH_SPECIES_CLOUD;
        if (!cloud) continue;
        derived.inputs.push_back({i});
        text += " and " + variable.name;
        break;
    }
    derived.value = [gas = model.gas, latent = model.latentHeatJPerKg](std::span<const double> of,
                                                                       std::size_t) {
        const double water = of.size() > 2 ? of[2] : 0.0;
        return les::temperatureK(of[0], of[1], gas) + latent / gas.heatCapacity * water;
    };
    contents.addDerived(onCells(contents, "air_temperature", "air_temperature", "K", "from " + text,
                                NEPH_ROLE_AIR_TEMPERATURE),
                        std::move(derived));
}

/// Cloud water and ice, which total water holds beside vapour.
std::vector<std::size_t> cloudOf(const les::Contents& contents) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < contents.description.variables.size(); ++i) {
        const plugin::Variable& variable = contents.description.variables[i];
        if (variable.role == NEPH_ROLE_MIXING_RATIO &&
            (variable.species == NEPH_SPECIES_CLOUD || variable.species == NEPH_SPECIES_ICE)) {
            found.push_back(i);
        }
    }
    return found;
}

/// Vapour per kg of dry air.
void deriveVapour(const Model& model, const Meanings& meanings, les::Contents& contents) {
    const auto vapour = meanings.find(Meaning::vapour);
    const auto total = meanings.find(Meaning::totalWater);
    if (vapour && !meanings.perMoistAir.contains(*vapour)) {
        contents.vapour = vapour;
        contents.description.variables[*vapour].role = NEPH_ROLE_WATER_VAPOUR;
        return;
    }
    if (!vapour && !total) return;
    const bool moist = vapour || model.perMoistAir;
    les::Derived derived{{{vapour ? *vapour : *total}}, {}};
    std::string text = nameAt(contents, derived.inputs[0].variable);
    if (!vapour) {
        for (const std::size_t cloud : cloudOf(contents)) {
            derived.inputs.push_back({cloud});
            text += " less " + nameAt(contents, cloud);
        }
    }
    derived.value = [moist](std::span<const double> of, std::size_t) {
        double ratio = of[0];
        for (std::size_t i = 1; i < of.size(); ++i) ratio -= of[i];
        return moist ? ratio / (1.0 - of[0]) : ratio;
    };
    contents.vapour = contents.sources.size();
    contents.addDerived(
        onCells(contents, "water_vapour_mixing_ratio", "humidity_mixing_ratio", "kg kg-1",
                text + (moist ? ", per kg of dry air" : ""), NEPH_ROLE_WATER_VAPOUR),
        std::move(derived));
}

/// Gives the density that the model states its role.
void settleDensity(const Meanings& meanings, les::Contents& contents) {
    auto& variables = contents.description.variables;
    if (meanings.find(Meaning::dryDensity)) return;
    if (const auto reference = meanings.find(Meaning::referenceDensity)) {
        variables[*reference].role = NEPH_ROLE_DRY_AIR_DENSITY;
        variables[*reference].reason += "; contents are amounts times it, as in the model";
        return;
    }
    const auto moist = meanings.find(Meaning::airDensity);
    if (!moist) return;
    les::Derived derived{{{*moist}}, {}};
    std::string text = nameAt(contents, *moist);
    if (contents.vapour) {
        derived.inputs.push_back({*contents.vapour});
        text += " and " + nameAt(contents, *contents.vapour);
    } else {
        note(contents, "Water vapour is missing: the density of air is taken as that of dry air.");
    }
    derived.value = [](std::span<const double> of, std::size_t) {
        return of[0] / (1.0 + (of.size() > 1 ? std::max(of[1], 0.0) : 0.0));
    };
    contents.addDerived(onCells(contents, "dry_air_density", "", "kg m-3", "from " + text,
                                NEPH_ROLE_DRY_AIR_DENSITY),
                        std::move(derived));
}

bool has(const les::Contents& contents, NephSpecies species) {
    return std::ranges::any_of(contents.description.variables, [&](const plugin::Variable& each) {
        return each.role == NEPH_ROLE_MIXING_RATIO && each.species == species;
    });
}

/// Share of the warm phase: 0 at `least` K and below, 1 at `most` K and above, linear between.
double warmShare(double kelvin, double least, double most) {
    return std::clamp((kelvin - least) / (most - least), 0.0, 1.0);
}

/// A part of a sum, by temperature.
struct Part {
    NephSpecies species;
    const char* name;
    double (*share)(double kelvin);
};

// [Khairoutdinov03], and tbgmin … tgrmax of SAM's micro_params: limits of cloud, of precipitation,
// and of graupel among the ice of precipitation.
double cloudShare(double kelvin) {
    return warmShare(kelvin, 253.16, 273.16);
}
double rainShare(double kelvin) {
    return warmShare(kelvin, 268.16, 283.16);
}
double graupelShare(double kelvin) {
    return warmShare(kelvin, 223.16, 283.16);
}
constexpr Part kCloudParts[] = {
    {NEPH_SPECIES_CLOUD, "liquid", &cloudShare},
    {NEPH_SPECIES_ICE, "ice", [](double kelvin) { return 1.0 - cloudShare(kelvin); }}};
constexpr Part kFallingParts[] = {
    {NEPH_SPECIES_RAIN, "rain", &rainShare},
    {NEPH_SPECIES_SNOW, "snow",
     [](double kelvin) { return (1.0 - rainShare(kelvin)) * (1.0 - graupelShare(kelvin)); }},
    {NEPH_SPECIES_GRAUPEL, "graupel",
     [](double kelvin) { return (1.0 - rainShare(kelvin)) * graupelShare(kelvin); }}};

void divide(const Meanings& meanings, Meaning meaning, std::span<const Part> parts,
            les::Contents& contents) {
    const auto whole = meanings.find(meaning);
    const bool there =
        std::ranges::any_of(parts, [&](const Part& part) { return has(contents, part.species); });
    if (!whole || there) return;
    const std::string name = nameAt(contents, *whole);
    const auto temperature = contents.find(NEPH_ROLE_AIR_TEMPERATURE);
    if (!temperature) {
        auto& variable = contents.description.variables[*whole];
        variable.role = NEPH_ROLE_MIXING_RATIO;
        variable.species = parts.front().species;
        note(contents, fmt::format("{} is drawn as {} altogether: without a temperature it cannot "
                                   "be divided.",
                                   name, les::speciesName(variable.species)));
        return;
    }
    for (const Part& part : parts) {
        const std::string partName = name + "_" + part.name;
        contents.addDerived(
            onCells(contents, partName.c_str(), "", "kg kg-1",
                    fmt::format("the part of {} that the model takes as {} by temperature", name,
                                les::speciesName(part.species)),
                    NEPH_ROLE_MIXING_RATIO, part.species),
            {{{*whole}, {*temperature}},
             [share = part.share](std::span<const double> of, std::size_t) {
                 return of[0] * share(of[1]);
             }});
    }
    note(contents, fmt::format("{} is divided by temperature, as SAM's single-moment scheme does "
                               "(Khairoutdinov and Randall 2003).",
                               name));
}

/// Amounts per kg of moist air, per kg of dry air: r = q / (1 − Σ q), the sum over all water.
void makeDry(const Model& model, const Meanings& meanings, les::Contents& contents) {
    const auto isMoist = [&](std::size_t index) {
        const auto& derived = contents.sources[index].derived;
        if (!derived) return meanings.perMoistAir.contains(index);
        return std::ranges::all_of(derived->inputs, [&](const les::Derived::Input& input) {
            return meanings.perMoistAir.contains(input.variable);
        });
    };
    std::vector<std::size_t> moist;
    for (std::size_t i = 0; i < contents.sources.size(); ++i) {
        const bool amount = contents.description.variables[i].role == NEPH_ROLE_MIXING_RATIO;
        if (amount && isMoist(i)) moist.push_back(i);
    }
    const auto total = meanings.find(Meaning::totalWater);
    const auto vapour = meanings.find(Meaning::vapour);
    const bool specific = vapour && meanings.perMoistAir.contains(*vapour);
    // The model itself multiplies by its reference density.
    if (moist.empty() || meanings.find(Meaning::referenceDensity)) return;
    std::vector<les::Derived::Input> water;
    const bool whole = total && !specific && model.perMoistAir;
    if (specific) water.push_back({*vapour});
    if (whole) water.push_back({*total});
    for (const std::size_t index : moist) {
        const NephSpecies species = contents.description.variables[index].species;
        const bool counted =
            whole && (species == NEPH_SPECIES_CLOUD || species == NEPH_SPECIES_ICE);
        if (!counted) water.push_back({index});
    }
    if (!specific && !whole) {
        note(contents,
             "Amounts per kg of moist air are taken without vapour to those of dry air: "
             "it is not in the file, and they may be 2 % too small.");
    }
    for (const std::size_t index : moist) {
        plugin::Variable variable = contents.description.variables[index];
        les::Derived derived{{{index}}, [](std::span<const double> of, std::size_t) {
                                 double dry = 1.0;
                                 for (std::size_t i = 1; i < of.size(); ++i) dry -= of[i];
                                 return dry > 0.0 ? of[0] / dry
                                                  : std::numeric_limits<double>::quiet_NaN();
                             }};
        derived.inputs.insert(derived.inputs.end(), water.begin(), water.end());
        contents.description.variables[index].role = NEPH_ROLE_OTHER;
        contents.description.variables[index].species = NEPH_SPECIES_NONE;
        variable.reason += fmt::format("; computed from {} per kg of moist air", variable.name);
        variable.description = variable.name + " per kg of dry air";
        variable.standardName.clear();
        variable.name += "_per_dry_air";
        contents.addDerived(std::move(variable), std::move(derived));
    }
}

}  // namespace

std::optional<std::size_t> Meanings::find(Meaning meaning) const {
    const auto found = known.find(meaning);
    if (found == known.end()) return {};
    return known.lower_bound(meaning)->second;
}

void deriveAir(const Model& model, Meanings& meanings, les::Contents& contents) {
    derivePressure(meanings, contents);
    deriveTheta(meanings, contents);
    deriveTemperature(model, meanings, contents);
    deriveVapour(model, meanings, contents);
    settleDensity(meanings, contents);
}

void deriveWater(const Model& model, const Meanings& meanings, les::Contents& contents) {
    divide(meanings, Meaning::cloudCondensate, kCloudParts, contents);
    divide(meanings, Meaning::precipitation, kFallingParts, contents);
    makeDry(model, meanings, contents);
}

void deriveNumbers(const Meanings& meanings, les::Contents& contents) {
    const auto density = contents.find(NEPH_ROLE_DRY_AIR_DENSITY);
    if (!density) return;
    for (const std::size_t index : meanings.perVolume) {
        plugin::Variable variable = contents.description.variables[index];
        contents.description.variables[index].species = NEPH_SPECIES_NONE;
        variable.role = NEPH_ROLE_NUMBER_CONCENTRATION;
        variable.units = "kg-1";
        variable.standardName.clear();
        variable.reason += fmt::format("; divided by {}", nameAt(contents, *density));
        variable.description = variable.name + " per kg of dry air";
        variable.name += "_per_kg";
        contents.addDerived(std::move(variable),
                            {{{index}, {*density}}, [](std::span<const double> of, std::size_t) {
                                 return of[0] / of[1];
                             }});
    }
}

}  // namespace cf
