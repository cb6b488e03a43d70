// aerosol.cpp: Mie's theory averaged over the sizes of grown particles.
#include "core/optics/aerosol.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/optics/mie.h"

namespace neph {
namespace {

constexpr double kAerosolGreenM = 550e-9, kWaterIndex = 1.333;  // [HQ73]

/// Sizes in standard deviations of the logarithm: cross-sections grow with up to r⁶, so the largest
/// particles count.
constexpr double kFirstDeviation = -4.0, kDeviationStep = 0.125;
constexpr int kAerosolSizes = 89;

/// Entries of the table are even in -ln(1 - humidity).
constexpr int kAerosolHumidities = 49;

double entryOf(double humidity) {
    const double within = std::clamp(humidity, 0.0, kMostAerosolHumidity);
    return std::log1p(-within) / std::log1p(-kMostAerosolHumidity) * (kAerosolHumidities - 1);
}

double humidityOf(int entry) {
    return -std::expm1(std::log1p(-kMostAerosolHumidity) * entry / (kAerosolHumidities - 1));
}

}  // namespace

double radiusGrowth(double humidity, double hygroscopicity) {
    const double within = std::clamp(humidity, 0.0, kMostAerosolHumidity);
    return std::cbrt(1.0 + hygroscopicity * within / (1.0 - within));
}

double meanExtinctionM2(const AerosolKind& kind, double humidity) {
    const double growth = radiusGrowth(humidity, kind.hygroscopicity);
    const double dryShare = 1.0 / (growth * growth * growth);
    const std::complex<double> index = kWaterIndex + (kind.dryIndex - kWaterIndex) * dryShare;
    const double logDeviation = std::log(kind.deviation);
    double sumM2 = 0.0, number = 0.0;
    for (int i = 0; i < kAerosolSizes; ++i) {
        const double u = kFirstDeviation + kDeviationStep * i;
        const double radiusM = kind.medianRadiusM * growth * std::exp(u * logDeviation);
        const double x = 2.0 * std::numbers::pi * radiusM / kAerosolGreenM;
        const double weight = std::exp(-0.5 * u * u);
        number += weight;
        sumM2 += weight * std::numbers::pi * radiusM * radiusM *
                 mieEfficiencies(x, mieCoefficients(x, index)).extinction;
    }
    return sumM2 / number;
}

ExtinctionByHumidity::ExtinctionByHumidity(const AerosolKind& kind) {
    logM2_.reserve(kAerosolHumidities);
    for (int i = 0; i < kAerosolHumidities; ++i) {
        logM2_.push_back(std::log(meanExtinctionM2(kind, humidityOf(i))));
    }
}

double ExtinctionByHumidity::atM2(double humidity) const {
    const double at = entryOf(humidity);
    const int i = std::min(static_cast<int>(at), kAerosolHumidities - 2);
    const auto entry = static_cast<std::size_t>(i);
    return std::exp(std::lerp(logM2_[entry], logM2_[entry + 1], at - i));
}

}  // namespace neph
