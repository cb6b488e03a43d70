// packed_medium.cpp: extinction brick by brick, then mixture and map of bricks.
#include "app/render/packed_medium.h"

#include <fmt/format.h>

#include "app/render/medium_bake.h"
#include "app/render/noise_texture.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph::render {
namespace {

// What would dim a ray through the whole domain by less is not there: an eighth of a step of 8
// bits of a path that no cloud is as long as.
constexpr double kInvisibleDepth = 2e-3;

void makeTextures(const VolumeTextures& volume, bool needsSecond, PackedMedium& out) {
    const glm::ivec3 cells = (volume.grid.size + 1) / 2;
    const auto make = [](GLenum format, glm::ivec3 size) {
        gl::Texture texture = gl::Texture::make3D(format, size);
        texture.setLinear();
        return texture;
    };
    if (!out.extinction || out.extinction.size() != volume.grid.size) {
        out = {};
        out.extinction = make(GL_RG16F, volume.grid.size);
        glClearTexImage(out.extinction.name(), 0, GL_RG, GL_FLOAT, nullptr);
        out.first = make(GL_RGBA8, cells);
    }
    if (needsSecond != static_cast<bool>(out.second)) {
        out.second = needsSecond ? make(GL_RGBA8, cells) : gl::Texture();
    }
}

/// Uniforms that both passes have: what a texel of each species is worth.
void setSpecies(const VolumeTextures& volume, const MediumPlan& plan, const gl::Program& program) {
    for (int s = 0; s < kSpeciesCount; ++s) {
        const auto i = static_cast<std::size_t>(s);
        volume.held[i].bind(static_cast<GLuint>(s));
        program.setFloat(s, plan.extinctionPerHeld[i] * volume.perTexel[i]);
    }
}

std::vector<std::string> extinctionDefines(bool detailed) {
    return {fmt::format("DETAIL {}", detailed ? 1 : 0), fmt::format("NOISE_SIZE {}", kNoiseSize),
            fmt::format("NOISE_LEVELS {}", kNoiseLevels)};
}

/// Uniforms of the detail, by species.
void setDetail(const VolumeTextures& volume, const Look& look, const gl::Program& program) {
    for (int s = 0; s < kSpeciesCount; ++s) {
        const SpeciesLook& field = look.species[static_cast<std::size_t>(s)];
        const float tileM = glsl::kDetailFeaturesPerTile * field.noiseScaleM;
        program.setFloat(30 + s, field.noiseAmount);
        program.setFloat(36 + s, static_cast<float>(kNoiseSize) / tileM);
        program.setFloat(42 + s, field.noiseCharacter == NoiseCharacter::billow ? 0.0f : 1.0f);
    }
    program.setVec3(48, glm::vec3(volume.grid.spacingM));
}

void packExtinction(const VolumeTextures& volume, const Look& look, const gl::Texture* noise,
                    gl::ProgramCache& programs, PackedMedium& out) {
    const bool detailed = out.detail == PackedDetail::voxels && look.noise && noise != nullptr;
    const gl::Program& program =
        programs.get("pass/pack_extinction.comp", extinctionDefines(detailed));
    setSpecies(volume, out.plan, program);
    if (detailed) {
        setDetail(volume, look, program);
        noise->bind(6);
    }
    volume.blockList.bind(GL_SHADER_STORAGE_BUFFER, 0);
    out.extinction.bindImage(0, GL_READ_WRITE);
    program.dispatchGroups(static_cast<int>(volume.blocks.size()));
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void packMixture(const VolumeTextures& volume, gl::ProgramCache& programs, PackedMedium& out) {
    const gl::Program& program = programs.get(
        "pass/pack_mixture.comp", {fmt::format("MIXTURE_TEXTURES {}", out.mixtureCount())});
    setSpecies(volume, out.plan, program);
    for (int s = 0; s < kSpeciesCount; ++s) {
        program.setInt(kSpeciesCount + s, out.plan.classOf[static_cast<std::size_t>(s)]);
    }
    program.setFloat(12, static_cast<float>(volume.grid.spacingM.z));
    program.setFloat(13, kSkylightAsymmetry);
    program.setFloat(14, kGroundShare);
    out.extinction.bind(6);
    out.first.bindImage(0, GL_WRITE_ONLY);
    if (out.second) out.second.bindImage(1, GL_WRITE_ONLY);
    program.dispatch({out.first.size().x, out.first.size().y, 1});
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace

void packMedium(const VolumeTextures& volume, const Look& look, const gl::Texture* noise,
                gl::ProgramCache& programs, PackedMedium& out) {
    if (out.extinction) {  // a new volume may have other blocks: outside of them nothing is
        glClearTexImage(out.extinction.name(), 0, GL_RG, GL_FLOAT, nullptr);
    }
    repackMedium(volume, look, PackedDetail::voxels, noise, programs, out);
    out.extinction.bind(0);
    out.bricks = mapBricks(
        readBrickMaxima(programs.get("pass/brick_maximum.comp", {"PACKED 1", "CLASS_TEXTURES 1"}),
                        brickCount(volume.grid.size)),
        volume.grid, kInvisibleDepth);
}

void repackMedium(const VolumeTextures& volume, const Look& look, PackedDetail detail,
                  const gl::Texture* noise, gl::ProgramCache& programs, PackedMedium& out) {
    Look plain = look;
    plain.noise = false;
    const MediumPlan plan =
        planMedium(detail == PackedDetail::voxels ? plain : look, volume.holdings);
    makeTextures(volume, plan.classes.size() > 3, out);
    out.look = planMedium(look, volume.holdings);
    out.plan = plan;
    out.detail = detail;
    packExtinction(volume, look, noise, programs, out);
    packMixture(volume, programs, out);
}

}  // namespace neph::render
