// microhh_derived.h: what the host needs of a MicroHH case and its files do not hold as such.
#pragma once
#include "readers/les/contents.h"

namespace les {

/// MicroHH's number of rain drops, nr, is per m³, the host's per kg of air. Nothing is added
/// without a reference density.
void addRainNumber(Contents& contents);

/// Vapour, and temperature in place of that of the reference state, from thl and qt, ql and qi,
/// the inverse of MicroHH's thermo_moist_functions.h. Nothing is added without a reference
/// pressure.
void addHumidity(Contents& contents);

}  // namespace les
