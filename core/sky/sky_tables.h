// sky_tables.h: what renderers and the solver of light look up of sky and air, for one place of the
// sun and one altitude of the eye.
//
// Linear sRGB, as radiance where the sun outside the atmosphere has the luminance that irradiance
// 4 pi gives to isotropic scatter: 1. Layout: shaders/lib/sky_table.glsl, the first axis fastest.
#pragma once
#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/sky/atmosphere.h"

namespace neph {

/// Radiance of the sky above the horizon as a share of a colour: one by azimuth from the sun and
/// elevation.
struct SkyPattern {
    std::vector<float> radiance;  ///< kAroundAzimuths x kAroundElevations; irradiance pi
    double at(const glm::dvec3& towards, const glm::dvec3& towardsSun) const;
    double atHorizon() const;  ///< mean of all azimuths
};
inline constexpr std::size_t kSkyPatterns = 2;

/// What lights a cloud.
struct SkyDome {
    glm::dvec3 towardsSun{0.0, 0.0, 1.0};
    std::array<SkyPattern, kSkyPatterns> patterns;
    std::vector<float> sunByAltitude;  ///< luminance of the sun, 1 outside the atmosphere
    /// Flux upwards of the air beneath a cloud, over the flux that falls on the ground: the albedo
    /// that it has as seen from above; and what it leaves of light that comes from the ground.
    double airAlbedo = 0.0, airClear = 1.0;
    double sunAt(double altitudeM) const;
};

struct SkyTables {
    std::vector<glm::vec4> eyeSky;    ///< the sky from the eye
    std::vector<glm::vec4> air;       ///< that air between the eye and a distance sends
    std::vector<glm::vec4> sunnyAir;  ///< of it, sunlight scattered once
    std::vector<glm::vec4> clear;     ///< that it leaves; elevations x distances
    /// That its molecules, and its haze, send where light of radiance 1 comes from all directions;
    /// likewise.
    std::vector<glm::vec4> byMolecules, byHaze;
    std::vector<glm::vec4> around;  ///< the sky from other altitudes
    /// By altitude: the sun, and the colours of the sky's patterns; a row each.
    std::vector<glm::vec4> byAltitude;
    glm::dvec3 skyOnGround{0.0};  ///< irradiance of the sky on level ground over 4 pi
    std::shared_ptr<const SkyDome> dome;
};

/// Of the sky from one altitude, which the patterns are taken from, as the eye sees it.
SkyTables makeSkyTables(const Atmosphere& air, const glm::dvec3& towardsSun, double eyeAltitudeM);

/// The parts of it that depend on the altitude of the eye.
void fillEyeTables(double eyeAltitudeM, const Atmosphere& air, const glm::dvec3& towardsSun,
                   SkyTables& tables);

}  // namespace neph
