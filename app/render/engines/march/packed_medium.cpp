// packed_medium.cpp: extinction brick by brick, then mixture and map of bricks.
#include "app/render/engines/march/packed_medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/render/medium/detail_kinds.h"
#include "app/render/medium/medium_bake.h"
#include "app/render/medium/noise_texture.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph::render {

#include "shaders/shared/march_layout.glsl"

namespace {

// What would dim a ray through the whole domain by less is not there: half a step of 8 bits, and
// no cloud is as long.
constexpr double kInvisibleDepth = 2e-3;

static_assert(kSpeciesCount <= 2 * kClassesBesideSkylight, "two mixture textures hold all classes");
static_assert(kMarchExtinctionUnit == kMedium0Unit, "medium/sun_shown.comp reads it there");

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

/// The species that both passes read, in the order of their textures, and their classes.
struct Visible {
    std::vector<int> species, classes;
};

Visible visibleIn(const MediumPlan& plan) {
    Visible visible;
    for (int s = 0; s < kSpeciesCount; ++s) {
        const int c = plan.classOf[static_cast<std::size_t>(s)];
        if (c < 0) continue;
        visible.species.push_back(s);
        visible.classes.push_back(c);
    }
    if (visible.species.empty()) return {{0}, {0}};  // one that has no extinction
    return visible;
}

/// What a texel of each species is worth.
void setSpecies(const VolumeTextures& volume, const MediumPlan& plan, const Visible& visible,
                const gl::Program& program) {
    for (std::size_t i = 0; i < visible.species.size(); ++i) {
        const auto s = static_cast<std::size_t>(visible.species[i]);
        volume.held[s].bind(static_cast<GLuint>(kHeldUnit + static_cast<int>(i)));
        program.setFloat(kPackExtinctionPerTexelLocation + static_cast<int>(i),
                         plan.extinctionPerHeld[s] * volume.perTexel[s]);
    }
}

std::vector<Detail> detailsOf(const VolumeTextures& volume, const Look& look,
                              const Visible& visible) {
    std::vector<Detail> details;
    for (const int s : visible.species) {
        const SpeciesLook& field = look.species[static_cast<std::size_t>(s)];
        const float scaleM = noiseScaleM(field, volume.cellM);
        const glm::vec2 fit =
            sidesRepeat(look) ? fitNoise(scaleM, volume.grid.extentM()) : glm::vec2(1.0f);
        details.push_back({field.noiseAmount, scaleM, fit, field.noiseCharacter});
    }
    return details;
}

/// Uniforms of the detail.
void setDetail(const VolumeTextures& volume, const std::vector<Detail>& details,
               const DetailKinds& kinds, const gl::Program& program) {
    for (std::size_t i = 0; i < details.size(); ++i) {
        program.setFloat(kPackAmountLocation + static_cast<int>(i), details[i].amount);
    }
    for (std::size_t k = 0; k < kinds.first.size(); ++k) {
        const Detail& detail = details[static_cast<std::size_t>(kinds.first[k])];
        const glm::vec2 tileM = glsl::kDetailFeaturesPerTile * detail.scaleM * detail.fit;
        const glm::vec2 perM = static_cast<float>(kNoiseSize) / tileM;
        const bool billow = detail.character == NoiseCharacter::billow;
        program.setVec3(kPackTexelsPerMLocation + static_cast<int>(k), {perM, perM.x});
        program.setFloat(kPackCharacterLocation + static_cast<int>(k), billow ? 0.0f : 1.0f);
    }
    program.setVec3(kPackVoxelLocation, glm::vec3(volume.grid.spacingM));
    program.setVec3(kPackMovedLocation, glm::vec3(volume.grid.movedM, 0.0f));
}

void packExtinction(const VolumeTextures& volume, const Look& look, const gl::Texture* noise,
                    gl::ProgramCache& programs, PackedMedium& out) {
    const bool detailed = out.detail == PackedDetail::voxels && look.noise && noise != nullptr;
    const Visible visible = visibleIn(out.plan);
    const std::vector<Detail> details = detailsOf(volume, look, visible);
    const DetailKinds kinds = kindsOf(details);
    std::vector<std::string> names{fmt::format("SPECIES {}", visible.species.size()),
                                   fmt::format("DETAIL {}", detailed ? 1 : 0)};
    if (detailed) {
        names.push_back(fmt::format("KINDS {}", kinds.first.size()));
        names.push_back(fmt::format("KIND_OF_SPECIES int[]({})", fmt::join(kinds.of, ", ")));
    }
    const gl::Program& program = programs.get("march/pack_extinction.comp", names);
    setSpecies(volume, out.plan, visible, program);
    if (detailed) {
        setDetail(volume, details, kinds, program);
        noise->bind(kBesideHeldUnit);
    }
    volume.blockList.bind(GL_SHADER_STORAGE_BUFFER, kMarchBlocksBuffer);
    out.extinction.bindImage(kMarchExtinctionImage, GL_READ_WRITE);
    program.dispatchGroups(static_cast<int>(volume.blocks.size()));
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void packMixture(const VolumeTextures& volume, gl::ProgramCache& programs, PackedMedium& out) {
    const Visible visible = visibleIn(out.plan);
    const gl::Program& program =
        programs.get("march/pack_mixture.comp",
                     {fmt::format("MIXTURE_TEXTURES {}", out.mixtureCount()),
                      fmt::format("SPECIES {}", visible.species.size()),
                      fmt::format("CLASS_OF_SPECIES int[]({})", fmt::join(visible.classes, ", "))});
    setSpecies(volume, out.plan, visible, program);
    const glm::vec3 voxels(volume.grid.size);
    glm::vec3 ofTexture = 2.0f / voxels;
    if (out.plan.repeats) ofTexture = {1.0f / glm::vec2(out.first.size()), ofTexture.z};
    program.setVec3(kPackCellLocation, ofTexture);
    program.setFloat(kPackLayerLocation, static_cast<float>(volume.grid.spacingM.z));
    program.setFloat(kPackAsymmetryLocation, kSkylightAsymmetry);
    program.setFloat(kPackGroundLocation, kGroundShare);
    out.extinction.bind(kBesideHeldUnit);
    out.first.bindImage(kPackMixture0Image, GL_WRITE_ONLY);
    if (out.second) out.second.bindImage(kPackMixture1Image, GL_WRITE_ONLY);
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
    out.extinction.bind(kMarchExtinctionUnit);
    const gl::Texture maxima = gl::Texture::make3D(GL_R32F, brickCount(volume.grid.size));
    const std::vector<std::string> names{fmt::format("PERIODIC {}", out.plan.repeats ? 1 : 0)};
    glClearTexImage(maxima.name(), 0, GL_RED, GL_FLOAT, nullptr);
    maxima.bindImage(kBrickMaximumImage, GL_WRITE_ONLY);
    volume.blockList.bind(GL_SHADER_STORAGE_BUFFER, kMarchBlocksBuffer);
    programs.get("march/brick_maximum.comp", names)
        .dispatchGroups(static_cast<int>(volume.blocks.size()));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    out.bricks = mapBricks(readBack(maxima), volume.grid, kInvisibleDepth);
}

void repackMedium(const VolumeTextures& volume, const Look& look, PackedDetail detail,
                  const gl::Texture* noise, gl::ProgramCache& programs, PackedMedium& out) {
    Look plain = look;
    plain.noise = false;
    const MediumPlan plan = planMedium(detail == PackedDetail::voxels ? plain : look, volume);
    makeTextures(volume, plan.classes.size() > kClassesBesideSkylight, out);
    out.look = planMedium(look, volume);
    out.plan = plan;
    out.detail = detail;
    for (gl::Texture* texture : {&out.extinction, &out.first, &out.second}) {
        if (*texture) texture->setRepeatAcross(plan.repeats);
    }
    packExtinction(volume, look, noise, programs, out);
    packMixture(volume, programs, out);
}

}  // namespace neph::render
