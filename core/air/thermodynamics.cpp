// thermodynamics.cpp: formulas of [Bolton80].
#include "core/air/thermodynamics.h"

#include <algorithm>
#include <cmath>

#include "core/sky/humidity.h"

namespace neph {
namespace {

constexpr double kGasRatio = 0.622;  // of dry air and vapour [Bolton80]
constexpr double kReferencePa = 1.0e5;

double vapourPressurePa(double pressurePa, double vapourRatio) {
    const double ratio = std::max(vapourRatio, 0.0);
    return pressurePa * ratio / (kGasRatio + ratio);
}

double saturatedThetaE(double pressurePa, double temperatureK) {
    return equivalentPotentialTemperatureK(pressurePa, temperatureK,
                                           saturationRatio(pressurePa, temperatureK));
}

}  // namespace

double potentialTemperatureK(double pressurePa, double temperatureK) {
    return temperatureK * std::pow(kReferencePa / pressurePa, kPoissonDry);
}

double virtualTemperatureK(double temperatureK, double vapourRatio) {
    const double ratio = std::max(vapourRatio, 0.0);
    return temperatureK * (1.0 + ratio / kGasRatio) / (1.0 + ratio);
}

double saturationRatio(double pressurePa, double temperatureK) {
    const double vapour = saturationPressurePa(temperatureK);
    return kGasRatio * vapour / std::max(pressurePa - vapour, 0.1 * vapour);
}

double dewPointK(double pressurePa, double vapourRatio) {
    const double vapour = vapourPressurePa(pressurePa, vapourRatio);
    if (vapour <= 0.0) return 0.0;
    // The inverse of [Bolton80] eq. 10.
    const double logRatio = std::log(vapour / 611.2);
    return std::max(kFreezingK + 243.5 * logRatio / (17.67 - logRatio), 0.0);
}

double condensationTemperatureK(double pressurePa, double temperatureK, double vapourRatio) {
    const double vapourHpa = 0.01 * vapourPressurePa(pressurePa, vapourRatio);
    if (vapourHpa <= 0.0) return 0.0;
    const double lifted =
        2840.0 / (3.5 * std::log(temperatureK) - std::log(vapourHpa) - 4.805) + 55;
    return std::min(lifted, temperatureK);
}

double condensationPressurePa(double pressurePa, double temperatureK, double vapourRatio) {
    const double lifted = condensationTemperatureK(pressurePa, temperatureK, vapourRatio);
    return pressurePa * std::pow(lifted / temperatureK, 1.0 / kPoissonDry);
}

double equivalentPotentialTemperatureK(double pressurePa, double temperatureK, double vapourRatio) {
    const double ratio = std::max(vapourRatio, 0.0);
    const double lifted = condensationTemperatureK(pressurePa, temperatureK, ratio);
    const double dryPa = pressurePa - vapourPressurePa(pressurePa, ratio);
    if (lifted <= 0.0) return potentialTemperatureK(pressurePa, temperatureK);
    const double dry = temperatureK * std::pow(kReferencePa / dryPa, kPoissonDry) *
                       std::pow(temperatureK / lifted, 0.28 * ratio);
    return dry * std::exp((3036.0 / lifted - 1.78) * ratio * (1.0 + 0.448 * ratio));
}

double pseudoadiabatK(double fromPa, double temperatureK, double toPa) {
    constexpr int kMostSteps = 30;
    constexpr double kCloseK = 1e-3, kDifferenceK = 0.05;
    const double wanted = saturatedThetaE(fromPa, temperatureK);
    // Newton's method on the logarithm, from the dry adiabat's warmer side.
    double temperature = temperatureK * std::pow(toPa / fromPa, 0.5 * kPoissonDry);
    for (int i = 0; i < kMostSteps; ++i) {
        const double at = std::log(saturatedThetaE(toPa, temperature) / wanted);
        const double slope = std::log(saturatedThetaE(toPa, temperature + kDifferenceK) /
                                      saturatedThetaE(toPa, temperature)) /
                             kDifferenceK;
        const double step = std::clamp(at / slope, -20.0, 20.0);
        temperature -= step;
        if (std::abs(step) < kCloseK) break;
    }
    return temperature;
}

}  // namespace neph
