// derived.h: air and hydrometeors that a file does not hold as such, from what it holds.
#pragma once
#include <map>
#include <optional>
#include <set>

#include "readers/cf_les/models.h"
#include "readers/les/contents.h"

namespace cf {

/// The variables of the contents by what they are.
struct Meanings {
    std::multimap<Meaning, std::size_t> known;
    std::set<std::size_t> perMoistAir;  ///< amounts per kg of moist air
    std::set<std::size_t> perVolume;    ///< numbers of particles per m³

    /// The first with a meaning.
    std::optional<std::size_t> find(Meaning meaning) const;
};

/// Pressure and potential temperature from a base state and deviations, temperature from liquid
/// water potential temperature, vapour from total water, and the density that the model states.
void deriveAir(const Model& model, Meanings& meanings, les::Contents& contents);

/// Divides sums of hydrometeors by the rules of the model where their parts are not there, and
/// makes amounts per kg of moist air such per kg of dry air.
void deriveWater(const Model& model, const Meanings& meanings, les::Contents& contents);

/// Numbers per m³ as numbers per kg, by the density of the contents.
void deriveNumbers(const Meanings& meanings, les::Contents& contents);

}  // namespace cf
