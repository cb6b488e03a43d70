// exposure.cpp: an incident-light meter, which does not depend on what the camera sees.
#include "core/look/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <vector>

#include "core/look/sun.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

// Of the lower and the upper part of deep clouds: after sunset the sun shines on one of them.
constexpr std::array kMeterAltitudesM{4000.0, 12000.0};
/// Dusk is shown darker than day, by this power of what falls on the cloud.
constexpr double kFollowed = 0.75;
constexpr std::size_t kMostKept = 4;  // while sliders change them

AtmosphereSpec specOf(const Look& look) {
    AtmosphereSpec spec;
    spec.visibilityM = static_cast<double>(look.visibilityM);
    spec.ozoneDobson = static_cast<double>(look.ozoneDobson);
    spec.groundAlbedo = look.groundVisible
                            ? static_cast<double>(glm::dot(groundAlbedo(look), glsl::kLuminance))
                            : 0.0;
    return spec;
}

double luminanceOf(const Spectrum& share) {
    return glm::dot(rgbOfSunlight(share), glm::dvec3(glsl::kLuminance));
}

}  // namespace

std::shared_ptr<const Atmosphere> atmosphereOf(const Look& look) {
    static std::mutex mutex;
    static std::vector<std::shared_ptr<const Atmosphere>> kept;
    const AtmosphereSpec spec = specOf(look);
    const std::lock_guard lock(mutex);
    for (const auto& each : kept) {
        if (each->spec() == spec) return each;
    }
    if (kept.size() >= kMostKept) kept.erase(kept.begin());
    return kept.emplace_back(std::make_shared<const Atmosphere>(spec));
}

/// By rays of equal shares of it.
Spectrum skyOnLevel(const Atmosphere& air, double altitudeM, double sunUp) {
    constexpr int kRings = 4, kAzimuths = 6;
    Spectrum sum;
    for (int i = 0; i < kRings; ++i) {
        for (int j = 0; j < kAzimuths; ++j) {
            const double up = std::sqrt((i + 0.5) / kRings);
            const double azimuth = std::numbers::pi * (j + 0.5) / kAzimuths;
            sum += air.along({altitudeM, up, azimuth, sunUp}).radiance;
        }
    }
    return static_cast<float>(std::numbers::pi / (kRings * kAzimuths)) * sum;
}

double meteredLight(const Look& look) {
    const auto air = atmosphereOf(look);
    const double sunUp = sunDirWorld(look).z;
    double most = 0.0;
    for (const double altitudeM : kMeterAltitudesM) {
        const double light = luminanceOf(air->sunlight(altitudeM, sunUp)) +
                             luminanceOf(skyOnLevel(*air, altitudeM, sunUp));
        most = std::max(most, light);
    }
    return most;
}

float exposureGain(const Look& look) {
    const float gain = std::exp2(look.exposureEv);
    if (!look.autoExposure || look.skyModel != SkyModel::atmosphere) return gain;
    constexpr double kDarkest = 1e-7;  // later than twilight
    const double light = std::max(meteredLight(look), kDarkest);
    return gain * static_cast<float>(std::pow(light, -kFollowed));
}

}  // namespace neph
