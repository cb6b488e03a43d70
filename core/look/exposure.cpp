// exposure.cpp: an incident-light meter, which does not depend on what the camera sees.
#include "core/look/exposure.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>
#include <tuple>
#include <vector>

#include "core/look/sun.h"
#include "core/sky/lunar_position.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

using glm::dvec3, glm::dmat3;

// Of deep clouds: after sunset the sun shines on their upper part alone.
constexpr std::array kMeterAltitudesM{4000.0, 8000.0, 12000.0, 16000.0};
/// Dusk is shown darker than day, by these powers of what falls on the cloud: while the sun shines
/// on it, and once there is less than such light and only the sky is left. Tuned by eye.
constexpr double kFollowed = 0.75, kFollowedInDusk = 0.62, kDusk = 0.01;
/// A night of full moon is shown two and a half stops darker than day. Tuned by eye.
constexpr double kFollowedByMoon = 0.87;
constexpr std::size_t kMostKept = 4;  // while sliders change them

AtmosphereSpec specOf(const Look& look) {
    assert(look.haze == Haze::fixed && "lookAsDrawn() makes the look that is drawn");
    AtmosphereSpec spec;
    spec.visibilityM = static_cast<double>(look.visibilityM);
    spec.ozoneDobson = static_cast<double>(look.ozoneDobson);
    spec.groundAlbedo = look.groundVisible
                            ? static_cast<double>(glm::dot(groundAlbedo(look), glsl::kLuminance))
                            : 0.0;
    return spec;
}

double luminanceOf(const dvec3& rgb) {
    return glm::dot(rgb, dvec3(glsl::kLuminance));
}

/// To the cones of an eye. [Lam85] of the XYZ of IEC 61966-2-1
dmat3 conesOfRgb() {
    const dmat3 xyzOfRgb{{0.4124564, 0.2126729, 0.0193339},
                         {0.3575761, 0.7151522, 0.1191920},
                         {0.1804375, 0.0721750, 0.9503041}};
    const dmat3 conesOfXyz{
        {0.8951, -0.7502, 0.0389}, {0.2664, 1.7135, -0.0685}, {-0.1614, 0.0367, 1.0296}};
    return conesOfXyz * xyzOfRgb;
}

/// Makes `light` white, and white no brighter.
dmat3 balanceFor(const dvec3& light) {
    const double luminance = luminanceOf(light);
    if (luminance <= 0.0) return dmat3(1.0);
    const dmat3 cones = conesOfRgb();
    const dvec3 white = cones * dvec3(1.0), met = cones * (light / luminance);
    const dvec3 scale = white / glm::max(met, dvec3(1e-3));
    return glm::inverse(cones) *
           dmat3(dvec3(scale.x, 0, 0), dvec3(0, scale.y, 0), dvec3(0, 0, scale.z)) * cones;
}

/// Of a sun without air by 4 pi times its sine: pi L / E is what satellites report.
double reflectanceGain(const Look& look) {
    constexpr double kLowestSine = 0.0872;  // of 5 degrees; products stop near there
    const double sine = std::max(sunDirWorld(look).z, kLowestSine);
    return 1.0 / (4.0 * std::max(static_cast<double>(shownIntensity(look)), 1e-12) * sine);
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

dvec3 meteredColour(const Look& look) {
    // Windows ask in every frame.
    static std::mutex mutex;
    static std::optional<std::tuple<AtmosphereSpec, double, dvec3>> last;
    const double sunUp = sunDirWorld(look).z;
    const auto air = atmosphereOf(look);
    const std::lock_guard lock(mutex);
    if (last && std::get<0>(*last) == air->spec() && std::get<1>(*last) == sunUp) {
        return std::get<2>(*last);
    }
    dvec3 sum(0.0);
    for (const double altitudeM : kMeterAltitudesM) {
        sum += rgbOfSunlight(air->sunlight(altitudeM, sunUp) + skyOnLevel(*air, altitudeM, sunUp));
    }
    const dvec3 mean = sum / static_cast<double>(kMeterAltitudesM.size());
    last = {air->spec(), sunUp, mean};
    return mean;
}

double meteredLight(const Look& look) {
    return luminanceOf(meteredColour(look));
}

float exposureGain(const Look& look) {
    const float gain = std::exp2(look.exposureEv);
    if (look.skyModel != SkyModel::atmosphere || !look.autoExposure) {
        return gain * std::exp2(kUnitEv100 - look.ev100);
    }
    constexpr double kDarkest = 1e-7;  // later than twilight
    const double light = std::max(meteredLight(look), kDarkest);
    const double byDay = std::pow(std::max(light, kDusk), -kFollowed);
    const double inDusk = std::pow(std::min(light / kDusk, 1.0), -kFollowedInDusk);
    const double moon =
        showsMoon(look)
            ? std::pow(moonShare(static_cast<double>(look.moonPhaseDeg)), -kFollowedByMoon)
            : 1.0;
    return gain * static_cast<float>(byDay * inDusk * moon);
}

double exposureValue(const Look& look) {
    return static_cast<double>(kUnitEv100) - std::log2(static_cast<double>(exposureGain(look)));
}

dvec3 discIrradiance(const Look& look, double altitudeM) {
    if (look.skyModel != SkyModel::atmosphere) return dvec3(0.0);
    const Spectrum share =
        atmosphereOf(look)->discLight(std::max(altitudeM, 0.0), sunDirWorld(look).z);
    return 4.0 * std::numbers::pi * static_cast<double>(shownIntensity(look)) *
           rgbOfSunlight(share);
}

glm::vec3 glareOf(const Look& look, double altitudeM) {
    if (!look.sunDisc || look.toneMap == ToneMap::reflectance) return glm::vec3(0.0f);
    return look.glare * glm::vec3(discIrradiance(look, altitudeM));
}

DisplayTones displayTones(const Look& look) {
    if (look.toneMap == ToneMap::reflectance) {
        return {glm::mat3(static_cast<float>(reflectanceGain(look))),
                static_cast<int>(ToneMap::linear)};
    }
    dmat3 exposure(static_cast<double>(exposureGain(look)));
    if (look.whiteBalance == WhiteBalance::sun) {
        const bool air = look.skyModel == SkyModel::atmosphere;
        exposure *= balanceFor(air ? meteredColour(look) : dvec3(look.sunColour));
    }
    return {glm::mat3(exposure), static_cast<int>(look.toneMap)};
}

}  // namespace neph
