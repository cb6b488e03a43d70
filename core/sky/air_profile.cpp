// air_profile.cpp: the standard atmosphere, and tables of it.
#include "core/sky/air_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/sky/atmosphere.h"

namespace neph {
namespace {

using glm::dvec3;

constexpr double kOzoneMiddleM = 25e3, kOzoneHalfM = 15e3;  // a tent. [Bruneton17]
/// At 550 nm, 15 degrees Celsius and 1013.25 hPa. [Bodhaine99] eq. 18, after Peck and Reeder
constexpr double kRefractivityAtSea = 2.7782e-4;

// [USSA76]: radius of the Earth, gravity, gas constant R*/M0 with R* = 8314.32, M0 = 28.9644.
constexpr double kGeopotentialRadiusM = 6'356'766.0;
constexpr double kGravityOverGas = 9.80665 / (8314.32 / 28.9644);

/// A layer of constant lapse rate, by geopotential height. [USSA76] table 4
struct StandardLayer {
    double baseM, baseK, lapseKPerM;
};
constexpr std::array kStandardLayers{
    StandardLayer{0.0, 288.15, -6.5e-3},  StandardLayer{11e3, 216.65, 0.0},
    StandardLayer{20e3, 216.65, 1.0e-3},  StandardLayer{32e3, 228.65, 2.8e-3},
    StandardLayer{47e3, 270.65, 0.0},     StandardLayer{51e3, 270.65, -2.8e-3},
    StandardLayer{71e3, 214.65, -2.0e-3}, StandardLayer{84'852.0, 186.946, 0.0},
};

/// Density as a share of that at sea level, and its derivative, 1/m.
struct Density {
    double share, perM;
};

/// Of a layer, at a height above its base: as a share of the density at its base.
double thinning(const StandardLayer& layer, double climbM) {
    if (layer.lapseKPerM == 0.0) return std::exp(-kGravityOverGas * climbM / layer.baseK);
    return std::pow(1.0 + layer.lapseKPerM * climbM / layer.baseK,
                    -kGravityOverGas / layer.lapseKPerM - 1.0);
}

Density moleculesAt(double altitudeM) {
    const double scale = kGeopotentialRadiusM / (kGeopotentialRadiusM + altitudeM);
    const double heightM = scale * altitudeM;
    double share = 1.0;
    std::size_t i = 0;
    for (; i + 1 < kStandardLayers.size() && heightM > kStandardLayers[i + 1].baseM; ++i) {
        share *=
            thinning(kStandardLayers[i], kStandardLayers[i + 1].baseM - kStandardLayers[i].baseM);
    }
    const StandardLayer& layer = kStandardLayers[i];
    const double climbM = heightM - layer.baseM;
    share *= thinning(layer, climbM);
    const double kelvin = layer.baseK + layer.lapseKPerM * climbM;
    return {share, -share * scale * scale * (kGravityOverGas + layer.lapseKPerM) / kelvin};
}

dvec3 exactDensity(double altitudeM) {
    return {moleculesAt(altitudeM).share, std::exp(-altitudeM / kHazeHeightM),
            std::max(0.0, 1.0 - std::abs(altitudeM - kOzoneMiddleM) / kOzoneHalfM)};
}

/// The derivative of n r by r.
double stretch(double altitudeM) {
    const Density density = moleculesAt(altitudeM);
    return 1.0 + kRefractivityAtSea * (density.share + (kEarthRadiusM + altitudeM) * density.perM);
}

double altitudeOfRaised(double raisedM) {
    double altitudeM = raisedM;
    for (int i = 0; i < 8; ++i) {  // Newton
        altitudeM += (raisedM - raisedOfAltitude(altitudeM)) / stretch(altitudeM);
    }
    return altitudeM;
}

BentAir exactBentAir(double raisedM) {
    const double altitudeM = altitudeOfRaised(raisedM);
    const double n = 1.0 + refractivity(altitudeM), perM = 1.0 / stretch(altitudeM);
    return {perM * exactDensity(altitudeM),
            -perM * kRefractivityAtSea * moleculesAt(altitudeM).perM / n};
}

/// Values at equal steps up to the top; exponentials take long, and between so many altitudes they
/// are linear within a thousandth.
template <typename Value>
class ByAltitude {
  public:
    ByAltitude(double topM, const auto& valueAt) : stepM_(topM / kLayers) {
        for (std::size_t i = 0; i <= kLayers + 1; ++i) {
            values_.push_back(valueAt(stepM_ * static_cast<double>(i)));
        }
    }
    Value at(double altitudeM) const {
        const double at = std::clamp(altitudeM / stepM_, 0.0, static_cast<double>(kLayers));
        const auto i = static_cast<std::size_t>(at);
        const double f = at - static_cast<double>(i);
        return (1.0 - f) * values_[i] + f * values_[i + 1];
    }

  private:
    static constexpr std::size_t kLayers = 1000;
    double stepM_;
    std::vector<Value> values_;
};

}  // namespace

dvec3 airDensity(double altitudeM) {
    static const ByAltitude<dvec3> table(kAtmosphereTopM, exactDensity);
    return table.at(altitudeM);
}

double refractivity(double altitudeM) {
    return kRefractivityAtSea * moleculesAt(altitudeM).share;
}

double raisedEarthRadiusM() {
    return (1.0 + kRefractivityAtSea) * kEarthRadiusM;
}

double raisedOfAltitude(double altitudeM) {
    const double n = refractivity(altitudeM);
    return altitudeM + n * (kEarthRadiusM + altitudeM) - kRefractivityAtSea * kEarthRadiusM;
}

BentAir bentAirAt(double raisedM) {
    using glm::dvec4;
    static const ByAltitude<dvec4> table(raisedOfAltitude(kAtmosphereTopM), [](double atM) {
        const BentAir air = exactBentAir(atM);
        return dvec4(air.columns, air.bendingPerM);
    });
    const dvec4 air = table.at(raisedM);
    return {dvec3(air), air.w};
}

}  // namespace neph
