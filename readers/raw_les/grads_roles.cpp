// grads_roles.cpp: roles by name, unit and levels.
#include "readers/raw_les/grads_roles.h"

#include <fmt/format.h>

#include "readers/les/twins.h"

namespace les {
namespace {

/// Hydrometeors and the state of the air: without them the rest would mislead.
bool isEssential(const KnownVariable& known) {
    return known.quantity != Quantity::number && known.quantity != Quantity::radius &&
           known.quantity != Quantity::length && known.quantity != Quantity::speed;
}

Error unitError(const CtlVariable& variable, Quantity quantity) {
    const std::string_view accepted = acceptedUnits(quantity);
    return {fmt::format("the unit of variable {} is not known", variable.name),
            variable.unit.empty() ? std::string("none in parentheses at the end of its line")
                                  : inQuotes(variable.unit),
            std::string(accepted),
            fmt::format("end the line of {} in the .ctl with ({})", variable.name,
                        accepted.substr(0, accepted.find(' ')))};
}

/// Whether a unit is that of a mixing ratio, not just a pure number.
bool isPerMass(std::string_view unit) {
    return unit.find("kg") != std::string_view::npos && toSi(Quantity::ratio, unit).has_value();
}

void note(Contents& contents, const std::vector<std::string>& names, std::string_view text) {
    if (names.empty()) return;
    contents.description.notes.push_back(
        fmt::format("{}: {}", joined(names),
                    fmt::format(fmt::runtime(text), names.size() == 1 ? "is" : "are")));
}

}  // namespace

std::optional<Meaning> GradsRoles::meaningOf(const CtlVariable& variable) {
    const KnownVariable* known = findKnown(variable.name);
    if (known == nullptr) {
        if (variable.levels > 1 && looksLikeHydrometeor(variable.name) &&
            isPerMass(variable.unit)) {
            unknown_.push_back(variable.name);
        }
        return {};
    }
    const bool hydrometeor = known->role == NEPH_ROLE_MIXING_RATIO;
    const bool ground = known->use == Use::ground;
    if (ground ? variable.planes() > 1 : variable.levels == 0) {
        if (hydrometeor) onePlane_.push_back(variable.name);
        return {};
    }
    if (!ground && !hydrometeor && variable.levels < levels_) {
        fewLevels_.push_back(variable.name);
        return {};
    }
    const auto conversion = toSi(known->quantity, variable.unit);
    if (!conversion && isEssential(*known)) throw unitError(variable, known->quantity);
    if (!conversion) {
        otherUnit_.push_back(fmt::format("{} ({})", variable.name,
                                         variable.unit.empty() ? "no unit" : variable.unit));
        return {};
    }
    return Meaning{known, *conversion};
}

void GradsRoles::add(const CtlVariable& variable, const std::optional<Meaning>& meaning,
                     Source source, Contents& contents) {
    neph::plugin::Variable entry{variable.name, "", variable.unit, variable.description};
    const std::size_t planes = variable.planes();
    entry.size = contents.description.size;
    if (!meaning || planes < levels_) entry.size[2] = static_cast<int>(planes);
    if (meaning) {
        const KnownVariable& known = *meaning->known;
        entry.role = known.role;
        entry.reason = "its name and unit";
        entry.species = known.species;
        entry.standardName = known.standardName;
        entry.units = siUnit(known.quantity);
        if (entry.species == NEPH_SPECIES_GRAUPEL && hail_) entry.species = NEPH_SPECIES_HAIL;
        const std::size_t index = contents.sources.size();
        if (known.use == Use::potentialTemperature) contents.potentialTemperature = index;
        if (known.use == Use::vapour) contents.vapour = index;
        if (known.use == Use::ground) terrain_.ground = index;
        if (known.use == Use::cellHeight) terrain_.cellHeight = index;
        if (known.role == NEPH_ROLE_MIXING_RATIO && planes < levels_) {
            entry.size = contents.description.size;
            source.storedLevels = planes;
            contents.description.notes.push_back(
                fmt::format("{} has {} of {} levels: it is set to zero above them.", variable.name,
                            planes, levels_));
        }
    }
    contents.add(std::move(entry), std::move(source));
}

void GradsRoles::finish(Contents& contents) const {
    const std::vector<std::string> twice = settleTwins(contents);
    note(contents, twice, "{} listed and not used, because another variable has the same meaning.");
    note(contents, onePlane_, "{} not drawn: a hydrometeor on a single level has no depth.");
    note(contents, fewLevels_, "{} not used, because not all levels have a value.");
    note(contents, otherUnit_, "{} not used, because the unit is of another kind.");
    note(contents, unknown_,
         "{} listed and not drawn: by name and unit a hydrometeor, but none that is known.");
}

}  // namespace les
