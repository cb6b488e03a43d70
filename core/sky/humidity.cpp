// humidity.cpp: four formulas.
#include "core/sky/humidity.h"

#include <algorithm>
#include <cmath>

namespace neph {
namespace {

constexpr double kGasRatio = 0.622;  // of dry air and vapour [Bolton80]
constexpr double kDryAir = 287.0;    // J/(kg K), as in docs/physics.md §7

}  // namespace

double saturationPressurePa(double temperatureK) {
    const double celsius = temperatureK - 273.15;
    return 611.2 * std::exp(17.67 * celsius / (celsius + 243.5));
}

double relativeHumidity(double pressurePa, double temperatureK, double vapourRatio) {
    const double ratio = std::max(vapourRatio, 0.0);
    return pressurePa * ratio / (kGasRatio + ratio) / saturationPressurePa(temperatureK);
}

double dryDensityKgPerM3(double pressurePa, double temperatureK, double vapourRatio) {
    return pressurePa / (kDryAir * temperatureK * (1.0 + std::max(vapourRatio, 0.0) / kGasRatio));
}

double visibilityOfHumidityM(double humidity) {
    // [UPP] CALVIS_GSD.f: visrh in km, qrh, and CONST1 = 3.0, which takes extinction to visibility.
    constexpr double kDriestM = 90e3, kGrowth = 2.5, kDry = 0.15, kMostGrowth = 0.8;
    const double contrast = std::log(0.02) / std::log(0.05);
    return contrast * kDriestM * std::exp(-kGrowth * std::clamp(humidity - kDry, 0.0, kMostGrowth));
}

}  // namespace neph
