// backdrop.cpp: as shaders/display/backdrop.glsl has it, with rays of the atmosphere for its
// tables.
#include "core/look/backdrop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/look/exposure.h"
#include "core/look/sun.h"
#include "core/sky/air_columns.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

using glm::dvec3, glm::vec3;

constexpr double kBesideHorizon = 1e-4;  // sine: the horizon itself is neither sky nor ground

/// Of a radiance per unit of the sun's irradiance; 1: isotropic scatter of full light.
dvec3 radianceOf(const Look& look, const Spectrum& share) {
    return 4.0 * std::numbers::pi * static_cast<double>(shownIntensity(look)) *
           rgbOfSunlight(share);
}

/// Light on level ground: 1 for an irradiance of 4 pi.
dvec3 gradientOnGround(const Look& look, double sunUp) {
    const vec3 sun = look.sunIntensity * static_cast<float>(std::max(sunUp, 0.0)) * look.sunColour;
    const vec3 sky = 0.5f * look.skyIntensity * (look.skyZenith + look.skyHorizon);
    return dvec3(sun + look.skylight * sky);
}

dvec3 atmosphereOnGround(const Look& look, const Atmosphere& air, double sunUp) {
    const Spectrum sky = skyOnLevel(air, 0.0, sunUp);
    const dvec3 sun = std::max(sunUp, 0.0) * rgbOfSunlight(air.sunlight(0.0, sunUp));
    return static_cast<double>(shownIntensity(look)) * (sun + rgbOfSunlight(sky));
}

}  // namespace

Backdrop::Backdrop(const Look& look, double eyeAltitudeM)
    : look_(look),
      altitudeM_(std::max(eyeAltitudeM, 0.0)),
      towardsSun_(sunDirWorld(look)),
      tones_(displayTones(look)) {
    dvec3 light = gradientOnGround(look, towardsSun_.z);
    if (look.skyModel == SkyModel::atmosphere) {
        air_ = atmosphereOf(look);
        horizonUp_ = neph::horizonUp(altitudeM_);
        light = atmosphereOnGround(look, *air_, towardsSun_.z);
    }
    groundRadiance_ = dvec3(shownGroundColour(look)) * light;
}

SkyRay Backdrop::rayIn(const dvec3& direction) const {
    const double azimuth =
        std::atan2(direction.x, direction.y) - std::atan2(towardsSun_.x, towardsSun_.y);
    return {altitudeM_, direction.z, azimuth, towardsSun_.z};
}

vec3 Backdrop::shown(const dvec3& radiance) const {
    return glsl::displayValue(tones_.exposure * vec3(radiance), tones_.curve);
}

vec3 Backdrop::sky(const dvec3& direction) const {
    if (!air_) {
        const float up = static_cast<float>(direction.z);
        return shown(
            dvec3(look_.skyIntensity * glsl::skyRadiance(up, look_.skyZenith, look_.skyHorizon)));
    }
    SkyRay ray = rayIn(direction);
    ray.up = std::max(ray.up, horizonUp_ + kBesideHorizon);
    return shown(radianceOf(look_, air_->along(ray).radiance));
}

std::optional<vec3> Backdrop::ground(const dvec3& direction) const {
    if (!look_.groundVisible) return {};
    SkyRay ray = rayIn(direction);
    ray.up = std::min(ray.up, horizonUp_ - kBesideHorizon);
    if (!air_) {
        const vec3 horizon = look_.skyIntensity * look_.skyHorizon;
        return shown(dvec3(glsl::hazyGround(vec3(groundRadiance_), horizon,
                                            static_cast<float>(-altitudeM_ / ray.up))));
    }
    const AirLight before = air_->along(ray);
    const dvec3 clear = rgbOfSunlight(before.clear) / rgbOfSunlight(Spectrum(1.0f));
    return shown(radianceOf(look_, before.radiance) + clear * groundRadiance_);
}

}  // namespace neph
