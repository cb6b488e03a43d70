// hydrometeors.h: which parameters are hydrometeors, their numbers and their radii.
#pragma once
#include <vector>

#include "readers/grib/product.h"

namespace grib {

/// A parameter with a role. The first of those with the same role and species that a file has is
/// used.
struct Hydrometeor {
    Parameter parameter;
    NephRole role;
    NephSpecies species;
    bool perMoistAir;  ///< else per kg of dry air, where it is a mixing ratio
    const char* description;
};

const std::vector<Hydrometeor>& hydrometeors();

/// "cloud water", "ice", ...
const char* speciesName(NephSpecies species);

}  // namespace grib
