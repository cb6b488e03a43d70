// sky_textures.cpp: which of the tables have to be made anew, and their upload.
#include "app/render/sky/sky_textures.h"

#include <algorithm>
#include <utility>

#include "core/look/exposure.h"
#include "core/look/sun.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph::render {

#include "shaders/shared/sky_layout.glsl"

namespace {

void fill(gl::Texture& texture, glm::ivec3 size, const std::vector<glm::vec4>& values) {
    if (texture.size() != size) {
        texture = size.z > 1 ? gl::Texture::make3D(GL_RGBA32F, size)
                             : gl::Texture::make2D(GL_RGBA32F, glm::ivec2(size));
        texture.setLinear();
    }
    texture.upload(GL_RGBA, GL_FLOAT, values.data());
}

/// The same sky with the sun in another azimuth, from which its tables count.
std::shared_ptr<const SkyDome> turned(SkyDome dome, const glm::dvec3& towardsSun) {
    dome.towardsSun = towardsSun;
    return std::make_shared<const SkyDome>(std::move(dome));
}

}  // namespace

void SkyTextures::update(const Look& look, double eyeAltitudeM) {
    if (look.skyModel == SkyModel::gradient) {
        *this = {};
        return;
    }
    auto air = atmosphereOf(look);
    const glm::dvec3 towardsSun = sunDirWorld(look);
    const double altitudeM = std::max(eyeAltitudeM, 0.0);
    const bool sameAir = air_ == air;
    air_ = std::move(air);
    const bool sameSky = sameAir && towardsSun_.z == towardsSun.z;  // turned at the most
    if (!sameSky) {
        tables_ = makeSkyTables(*air_, towardsSun, altitudeM);
        uploadSky();
    } else if (towardsSun_ != towardsSun) {
        tables_.dome = turned(*tables_.dome, towardsSun);
    }
    if (sameSky && eyeAltitudeM_ != altitudeM) {
        fillEyeTables(altitudeM, *air_, towardsSun, tables_);
    }
    if (!sameSky || eyeAltitudeM_ != altitudeM) uploadEye();
    towardsSun_ = towardsSun;
    eyeAltitudeM_ = altitudeM;
}

void SkyTextures::uploadSky() {
    using namespace glsl;
    fill(around_, {kAroundAzimuths, kAroundElevations, kAroundAltitudes}, tables_.around);
    fill(byAltitude_, {kAltitudes, kAltitudeRows, 1}, tables_.byAltitude);
}

void SkyTextures::uploadEye() {
    using namespace glsl;
    fill(eyeSky_, {kEyeSkyAzimuths, kEyeSkyElevations, 1}, tables_.eyeSky);
    fill(airLight_, {kAirAzimuths, kAirElevations, kAirDistances}, tables_.air);
    fill(sunnyAir_, {kAirAzimuths, kAirElevations, kAirDistances}, tables_.sunnyAir);
    fill(clear_, {kAirElevations, kAirDistances, 1}, tables_.clear);
    fill(byMolecules_, {kAirElevations, kAirDistances, 1}, tables_.byMolecules);
    fill(byHaze_, {kAirElevations, kAirDistances, 1}, tables_.byHaze);
}

void SkyTextures::bind() const {
    if (!hasAir()) return;
    eyeSky_.bind(kEyeSkyUnit);
    airLight_.bind(kAirUnit);
    sunnyAir_.bind(kSunnyAirUnit);
    clear_.bind(kClearAirUnit);
    byMolecules_.bind(kByMoleculesUnit);
    byHaze_.bind(kByHazeUnit);
    around_.bind(kAroundUnit);
    byAltitude_.bind(kByAltitudeUnit);
}

glm::vec3 SkyTextures::sunOnGround() const {
    return tables_.byAltitude.front();
}

glm::vec3 SkyTextures::patternOnGround(std::size_t pattern) const {
    return tables_.byAltitude[(1 + pattern) * static_cast<std::size_t>(glsl::kAltitudes)];
}

std::size_t SkyTextures::bytes() const {
    return eyeSky_.bytes() + airLight_.bytes() + sunnyAir_.bytes() + clear_.bytes() +
           byMolecules_.bytes() + byHaze_.bytes() + around_.bytes() + byAltitude_.bytes();
}

}  // namespace neph::render
