// hydrometeors.cpp: code tables 4.2-0-1 and 4.2-0-6.
#include "readers/grib/hydrometeors.h"

#include <array>

namespace grib {

const std::vector<Hydrometeor>& hydrometeors() {
    constexpr NephRole kRatio = NEPH_ROLE_MIXING_RATIO, kNumber = NEPH_ROLE_NUMBER_CONCENTRATION,
                       kRadius = NEPH_ROLE_EFFECTIVE_RADIUS;
    constexpr NephSpecies kCloud = NEPH_SPECIES_CLOUD, kIce = NEPH_SPECIES_ICE,
                          kRain = NEPH_SPECIES_RAIN, kSnow = NEPH_SPECIES_SNOW,
                          kGraupel = NEPH_SPECIES_GRAUPEL, kHail = NEPH_SPECIES_HAIL;
    static const std::vector<Hydrometeor> list{
        {{0, 1, 22}, kRatio, kCloud, false, "cloud mixing ratio"},
        {{0, 1, 83}, kRatio, kCloud, true, "specific cloud liquid water content"},
        {{0, 1, 82}, kRatio, kIce, false, "cloud ice mixing ratio"},
        {{0, 1, 23}, kRatio, kIce, false, "ice water mixing ratio"},
        {{0, 1, 84}, kRatio, kIce, true, "specific cloud ice water content"},
        {{0, 1, 24}, kRatio, kRain, false, "rain mixing ratio"},
        {{0, 1, 85}, kRatio, kRain, true, "specific rain water content"},
        {{0, 1, 25}, kRatio, kSnow, false, "snow mixing ratio"},
        {{0, 1, 86}, kRatio, kSnow, true, "specific snow water content"},
        {{0, 1, 32}, kRatio, kGraupel, false, "graupel mixing ratio"},
        {{0, 1, 71}, kRatio, kHail, false, "hail mixing ratio"},
        {{0, 6, 28}, kNumber, kCloud, false, "number of cloud droplets per mass of air"},
        {{0, 6, 29}, kNumber, kIce, false, "number of ice particles per mass of air"},
        {{0, 1, 100}, kNumber, kRain, false, "specific number concentration of rain"},
        {{0, 1, 101}, kNumber, kSnow, false, "specific number concentration of snow"},
        {{0, 1, 102}, kNumber, kGraupel, false, "specific number concentration of graupel"},
        {{0, 1, 103}, kNumber, kHail, false, "specific number concentration of hail"},
        {{0, 1, 129}, kRadius, kCloud, false, "effective radius of cloud water"},
        {{0, 1, 130}, kRadius, kRain, false, "effective radius of rain"},
        {{0, 1, 131}, kRadius, kIce, false, "effective radius of cloud ice"},
        {{0, 1, 132}, kRadius, kSnow, false, "effective radius of snow"},
        {{0, 1, 133}, kRadius, kGraupel, false, "effective radius of graupel"},
        {{0, 1, 134}, kRadius, kHail, false, "effective radius of hail"},
    };
    return list;
}

const char* speciesName(NephSpecies species) {
    constexpr std::array kNamesOfSpecies{"cloud water", "ice", "rain", "snow", "graupel", "hail"};
    return kNamesOfSpecies.at(static_cast<std::size_t>(species));
}

}  // namespace grib
