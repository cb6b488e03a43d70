// air.cpp: gas laws. The equations are those of docs/physics.md §7, with the constants of the model
// that wrote the data.
#include "readers/les/air.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/plugin/reader_abi.h"

namespace les {
namespace {

// [USSA76]: radius of the Earth, gravity, gas constant R*/M0 with R* = 8314.32, M0 = 28.9644.
constexpr double kEarthRadiusM = 6'356'766.0;
constexpr double kGravity = 9.80665;
constexpr double kGas = 8314.32 / 28.9644;

/// A layer of constant lapse rate. Heights are geopotential. [USSA76] table 4
struct Layer {
    double baseM, baseK, lapseKPerM;
};
constexpr std::array kLayers{
    Layer{0.0, 288.15, -6.5e-3},
    Layer{11'000.0, 216.65, 0.0},
    Layer{20'000.0, 216.65, 1.0e-3},
    Layer{32'000.0, 228.65, 2.8e-3},
};
constexpr double kTopM = 47'000.0;
constexpr double kSeaLevelPa = 101'325.0;

constexpr double kImpossible = std::numeric_limits<double>::quiet_NaN();

bool isPressure(double pa) {
    return pa >= NEPH_LEAST_PRESSURE_PA && pa <= NEPH_MOST_PRESSURE_PA;
}
bool isTemperature(double kelvin) {
    return kelvin >= NEPH_LEAST_TEMPERATURE_K && kelvin <= NEPH_MOST_TEMPERATURE_K;
}

/// Pressure at `heightM` divided by the pressure at the base of its layer: hydrostatic, with the
/// exponential form where the layer is isothermal. [USSA76] eq. 33a, 33b
double pressureRatio(const Layer& layer, double heightM) {
    const double climb = heightM - layer.baseM;
    if (layer.lapseKPerM == 0.0) return std::exp(-kGravity * climb / (kGas * layer.baseK));
    return std::pow(1.0 + layer.lapseKPerM * climb / layer.baseK,
                    -kGravity / (kGas * layer.lapseKPerM));
}

}  // namespace

double temperatureK(double thetaK, double pressurePa, const GasConstants& gas) {
    if (!isPressure(pressurePa)) return kImpossible;
    return thetaK * std::pow(pressurePa / gas.referencePressure, gas.dryGas / gas.heatCapacity);
}

double dryDensity(double temperatureK, double pressurePa, double vapourRatio,
                  const GasConstants& gas) {
    if (!isPressure(pressurePa) || !isTemperature(temperatureK)) return kImpossible;
    // Advection may leave small negative mixing ratios of vapour.
    const double moisture = 1.0 + std::max(vapourRatio, 0.0) * gas.vapour / gas.dryGas;
    return pressurePa / (gas.dryGas * temperatureK * moisture);
}

Air standardAtmosphere(double heightM) {
    // Geometric to geopotential height. [USSA76] eq. 18
    const double geopotential = kEarthRadiusM * heightM / (kEarthRadiusM + heightM);
    const double height = std::clamp(geopotential, -5000.0, kTopM);
    // Pressure accumulates over the layers below.
    double pressure = kSeaLevelPa;
    std::size_t i = 0;
    for (; i + 1 < kLayers.size() && height > kLayers[i + 1].baseM; ++i) {
        pressure *= pressureRatio(kLayers[i], kLayers[i + 1].baseM);
    }
    pressure *= pressureRatio(kLayers[i], height);
    const double temperature =
        kLayers[i].baseK + kLayers[i].lapseKPerM * (height - kLayers[i].baseM);
    return {temperature, pressure, pressure / (kGas * temperature)};
}

}  // namespace les
