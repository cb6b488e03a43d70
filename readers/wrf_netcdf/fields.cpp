// fields.cpp: the table of WRF's names, after the Registry of version 4.6.1 (Registry.EM_COMMON,
// registry.sbm).
#include "readers/wrf_netcdf/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace wrf {
namespace {

/// A name with a role. Several of one role and species are summed: P3 has up to three categories of
/// ice, the full spectral-bin scheme three habits.
struct KnownName {
    std::string_view name;
    NephRole role;
    NephSpecies species;
    std::string_view standardName = "";
    bool alias = false;  ///< of other programs: used where none of WRF's names is there
};
constexpr NephRole kRatio = NEPH_ROLE_MIXING_RATIO;
constexpr NephRole kNumber = NEPH_ROLE_NUMBER_CONCENTRATION;
constexpr NephRole kRadius = NEPH_ROLE_EFFECTIVE_RADIUS;
constexpr std::array kKnown{
    KnownName{"QCLOUD", kRatio, NEPH_SPECIES_CLOUD, "cloud_liquid_water_mixing_ratio"},
    KnownName{"QICE", kRatio, NEPH_SPECIES_ICE, "cloud_ice_mixing_ratio"},
    KnownName{"QICE2", kRatio, NEPH_SPECIES_ICE},
    KnownName{"QICE3", kRatio, NEPH_SPECIES_ICE},
    KnownName{"QICE4", kRatio, NEPH_SPECIES_ICE},
    KnownName{"QICEC", kRatio, NEPH_SPECIES_ICE},
    KnownName{"QICED", kRatio, NEPH_SPECIES_ICE},
    KnownName{"QICEP", kRatio, NEPH_SPECIES_ICE},
    KnownName{"QRAIN", kRatio, NEPH_SPECIES_RAIN},
    KnownName{"QSNOW", kRatio, NEPH_SPECIES_SNOW},
    KnownName{"QGRAUP", kRatio, NEPH_SPECIES_GRAUPEL},
    KnownName{"QGRAUPEL", kRatio, NEPH_SPECIES_GRAUPEL},
    KnownName{"QHAIL", kRatio, NEPH_SPECIES_HAIL},
    KnownName{"RE_CLOUD", kRadius, NEPH_SPECIES_CLOUD,
              "effective_radius_of_cloud_liquid_water_particles"},
    KnownName{"RE_ICE", kRadius, NEPH_SPECIES_ICE},
    KnownName{"RE_SNOW", kRadius, NEPH_SPECIES_SNOW},
    KnownName{"QNCLOUD", kNumber, NEPH_SPECIES_CLOUD},
    KnownName{"QNDROP", kNumber, NEPH_SPECIES_CLOUD},
    KnownName{"QNICE", kNumber, NEPH_SPECIES_ICE},
    KnownName{"QNICE2", kNumber, NEPH_SPECIES_ICE},
    KnownName{"QNICE3", kNumber, NEPH_SPECIES_ICE},
    KnownName{"QNICE4", kNumber, NEPH_SPECIES_ICE},
    KnownName{"QNICEC", kNumber, NEPH_SPECIES_ICE},
    KnownName{"QNICED", kNumber, NEPH_SPECIES_ICE},
    KnownName{"QNICEP", kNumber, NEPH_SPECIES_ICE},
    KnownName{"QNRAIN", kNumber, NEPH_SPECIES_RAIN},
    KnownName{"QNSNOW", kNumber, NEPH_SPECIES_SNOW},
    KnownName{"QNGRAUPEL", kNumber, NEPH_SPECIES_GRAUPEL},
    KnownName{"QNHAIL", kNumber, NEPH_SPECIES_HAIL},
    KnownName{"QNWFA", NEPH_ROLE_HYGROSCOPIC_AEROSOL_NUMBER, NEPH_SPECIES_NONE},
    KnownName{"QNIFA", NEPH_ROLE_DUST_NUMBER, NEPH_SPECIES_NONE},
    KnownName{"qc", kRatio, NEPH_SPECIES_CLOUD, "", true},
    KnownName{"clwmr", kRatio, NEPH_SPECIES_CLOUD, "", true},
    KnownName{"qi", kRatio, NEPH_SPECIES_ICE, "", true},
    KnownName{"icmr", kRatio, NEPH_SPECIES_ICE, "", true},
    KnownName{"qr", kRatio, NEPH_SPECIES_RAIN, "", true},
    KnownName{"rwmr", kRatio, NEPH_SPECIES_RAIN, "", true},
    KnownName{"qs", kRatio, NEPH_SPECIES_SNOW, "", true},
    KnownName{"snmr", kRatio, NEPH_SPECIES_SNOW, "", true},
    KnownName{"qg", kRatio, NEPH_SPECIES_GRAUPEL, "", true},
    KnownName{"grle", kRatio, NEPH_SPECIES_GRAUPEL, "", true},
    KnownName{"qh", kRatio, NEPH_SPECIES_HAIL, "", true},
};

/// Mixing ratios that are no hydrometeors of their own: vapour, parts and sums of the others.
constexpr std::array<std::string_view, 8> kNoHydrometeors{"QVAPOR", "QIR",    "QIR2", "QIR3",
                                                          "QIR4",   "QRIMEF", "CWM",  "QT"};

constexpr std::array<const char*, 6> kSpeciesNames{"cloud water", "ice",     "rain",
                                                   "snow",        "graupel", "hail"};
constexpr std::array<const char*, 6> kUsualNames{"QCLOUD", "QICE",   "QRAIN",
                                                 "QSNOW",  "QGRAUP", "QHAIL"};
// A stored variable that has given its name to the sum which it is a part of.
constexpr const char* kAlone = " alone";

const char* unitOf(NephRole role) {
    return role == kRatio ? "kg kg-1" : role == kRadius ? "m" : "kg-1";
}

std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

class HydrometeorFinder {
  public:
    HydrometeorFinder(const Tiles& tiles, const Scheme& scheme, UnitNotes& units,
                      std::vector<std::string>& notes)
        : tiles_(tiles), scheme_(scheme), units_(units), notes_(notes) {}

    std::vector<Field> find() {
        for (const KnownName& known : kKnown) take(known);
        for (Field& field : fields_) describe(field);
        if (scheme_.onePhase && !has(NEPH_SPECIES_ICE) && !has(NEPH_SPECIES_SNOW)) splitPhases();
        noteParts();
        noteLacking();
        noteUnknown();
        return std::move(fields_);
    }

  private:
    bool has(NephSpecies species) const {
        return std::ranges::any_of(fields_, [&](const Field& field) {
            return field.role == kRatio && field.species == species;
        });
    }

    /// Adds a known variable to the field of its role and species.
    void take(const KnownName& known) {
        const NcVariable* variable = tiles_.first().variable(known.name);
        if (variable == nullptr) return;
        const auto shape = tiles_.shapeOf(*variable);
        if (!variable->number || !shape || !shape->onCells()) {
            notes_.push_back(fmt::format(
                "{} is not used: it is {} on ({}), not a number in each cell "
                "of the grid.",
                variable->name, variable->number ? "stored" : "text", listOf(variable->axes)));
            return;
        }
        const auto term = termOf(*variable, unitOf(known.role), units_);
        if (!term) {
            if (known.role == kRatio) throw wrongUnit(*variable, unitOf(known.role));
            notes_.push_back(fmt::format("{} is not used: its units \"{}\" do not convert to {}.",
                                         variable->name, variable->units, unitOf(known.role)));
            return;
        }
        const auto same = std::ranges::find_if(fields_, [&](const Field& field) {
            return field.role == known.role && field.species == known.species;
        });
        // QNDROP is another name of QNCLOUD, not a second kind of droplets.
        if (same != fields_.end() && (known.alias || known.species != NEPH_SPECIES_ICE)) {
            notes_.push_back(
                fmt::format("{} is not used: {} stands for the same.", variable->name, same->name));
            return;
        }
        if (same != fields_.end()) {
            same->terms.push_back(*term);
            return;
        }
        Field field;
        field.role = known.role;
        field.species = known.species;
        field.standardName = known.standardName;
        field.terms = {*term};
        fields_.push_back(std::move(field));
        fields_.back().name = variable->name;
    }

    void describe(Field& field) const {
        const auto& length = tiles_.axes().length;
        std::vector<std::string> names;
        for (const Term& term : field.terms) names.push_back(term.variable->name);
        // A sum has the name that it would have without further parts, so that files of a series
        // which differ in their parts agree.
        field.name = names.front();
        if (field.species == NEPH_SPECIES_ICE && field.role != kRadius) {
            field.name = field.role == kRatio ? "QICE" : "QNICE";
        }
        field.units = unitOf(field.role);
        field.description = field.terms.size() == 1 ? field.terms.front().variable->description
                                                    : "sum of " + joined(names);
        field.reason = field.terms.size() == 1 ? "its name in WRF's Registry, or an alias of it"
                                               : "computed: " + field.description;
        field.size = {static_cast<int>(length[0]), static_cast<int>(length[1]),
                      static_cast<int>(length[2])};
    }

    /// Cloud water and ice share a class, rain and snow another.
    void splitPhases() {
        std::vector<Field> cold;
        for (Field& field : fields_) {
            if (field.role != kRatio ||
                (field.species != NEPH_SPECIES_CLOUD && field.species != NEPH_SPECIES_RAIN)) {
                continue;
            }
            Field ice = field;
            ice.species =
                field.species == NEPH_SPECIES_CLOUD ? NEPH_SPECIES_ICE : NEPH_SPECIES_SNOW;
            ice.source = Source::coldPart;
            ice.standardName = ice.species == NEPH_SPECIES_ICE ? "cloud_ice_mixing_ratio" : "";
            ice.description = field.name + " where the air is below 0 °C";
            field.source = Source::warmPart;
            field.description = field.name + " where the air is not below 0 °C";
            ice.name += ice.species == NEPH_SPECIES_ICE ? "_ice" : "_snow";
            field.name += "_liquid";
            cold.push_back(std::move(ice));
        }
        if (cold.empty()) return;
        std::ranges::move(cold, std::back_inserter(fields_));
        notes_.push_back(
            fmt::format("{} has one class for cloud water and ice and one for rain and "
                        "snow: below 0 °C QCLOUD is taken as ice and QRAIN as snow, as "
                        "the scheme does.",
                        schemeName(scheme_)));
    }

    /// Species that are sums of several variables.
    void noteParts() {
        for (const Field& field : fields_) {
            if (field.role != kRatio || field.terms.size() < 2) continue;
            std::vector<std::string> names;
            for (const Term& term : field.terms) names.push_back(term.variable->name);
            const bool rime = tiles_.first().variable("QIR") != nullptr;
            std::string species = kSpeciesNames[static_cast<std::size_t>(field.species)];
            species[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(species[0])));
            notes_.push_back(
                fmt::format("{} is the sum of {}{}.", species, fmt::join(names, " + "),
                            rime ? "; QIR and QIR2, the mass of rime, are parts of them" : ""));
        }
    }

    /// Hydrometeors that the run has and the file lacks.
    void noteLacking() {
        std::vector<std::string> lacking;
        for (NephSpecies species = NEPH_SPECIES_CLOUD; species <= NEPH_SPECIES_HAIL; ++species) {
            if (!scheme_.has(species) || has(species)) continue;
            const auto index = static_cast<std::size_t>(species);
            lacking.push_back(fmt::format("{} ({})", kSpeciesNames[index], kUsualNames[index]));
        }
        if (lacking.empty()) return;
        notes_.push_back(fmt::format("The run has hydrometeors that the file lacks: {} of {}.",
                                     joined(lacking), schemeName(scheme_)));
    }

    /// Fields that look like hydrometeors and have no known name.
    void noteUnknown() {
        std::vector<std::string> found;
        for (const NcVariable& variable : tiles_.first().variables()) {
            const std::string name = upper(variable.name);
            const auto isName = [&](const KnownName& each) {
                return upper(std::string(each.name)) == name;
            };
            const bool known = std::ranges::any_of(kKnown, isName) ||
                               std::ranges::find(kNoHydrometeors, name) != kNoHydrometeors.end();
            if (known || !name.starts_with('Q') || !variable.number) continue;
            const auto shape = tiles_.shapeOf(variable);
            const bool ratio = variable.units.find("kg") != std::string::npos &&
                               shared::conversion(variable.units, "kg kg-1").has_value();
            if (shape && shape->onCells() && ratio) {
                found.push_back(fmt::format("{} ({})", variable.name, variable.description));
            }
        }
        if (found.empty()) return;
        notes_.push_back(
            fmt::format("Mixing ratios without a known meaning are not drawn: {}.", joined(found)));
    }

    const Tiles& tiles_;
    const Scheme& scheme_;
    UnitNotes& units_;
    std::vector<std::string>& notes_;
    std::vector<Field> fields_;
};

}  // namespace

std::vector<Field> findHydrometeors(const Tiles& tiles, const Scheme& scheme, UnitNotes& unitNotes,
                                    std::vector<std::string>& notes) {
    return HydrometeorFinder(tiles, scheme, unitNotes, notes).find();
}

std::vector<Field> otherFields(const Tiles& tiles, const std::vector<Field>& taken) {
    std::vector<Field> fields;
    for (const NcVariable& variable : tiles.first().variables()) {
        const auto shape = tiles.shapeOf(variable);
        const auto same = std::ranges::find(taken, variable.name, &Field::name);
        const bool known = same != taken.end() && same->terms.size() < 2;
        // Plain integers are categories and masks.
        const bool listed = variable.number && (!variable.integer || variable.packing.packed());
        if (!listed || !shape || known) continue;
        Field field;
        field.name = variable.name + (same != taken.end() ? kAlone : "");
        field.standardName = variable.standardName;
        field.units = variable.units;
        field.description = variable.description;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            field.size[axis] = static_cast<int>(shape->size[axis]);
        }
        field.terms = {{&variable, {}}};
        fields.push_back(std::move(field));
    }
    return fields;
}

}  // namespace wrf
