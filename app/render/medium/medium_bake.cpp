// medium_bake.cpp: extinction of each class, skylight, and the map of bricks.
#include "app/render/medium/medium_bake.h"

#include <fmt/format.h>

namespace neph::render {
namespace {

constexpr double kInvisibleDepth = 1e-4;  // nobody sees; the slices are compared to 1e-3

std::vector<std::string> defines(const MediumTextures& medium) {
    return {fmt::format("CLASS_TEXTURES {}", medium.textureCount())};
}

void bakeExtinction(const VolumeTextures& volume, gl::ProgramCache& programs, MediumTextures& out) {
    const gl::Program& program = programs.get("medium/bake.comp", defines(out));
    for (int s = 0; s < kSpeciesCount; ++s) {
        const auto i = static_cast<std::size_t>(s);
        volume.held[i].bind(static_cast<GLuint>(kHeldUnit + s));
        program.setFloat(kExtinctionPerHeldLocation + s,
                         out.plan.extinctionPerHeld[i] * volume.perTexel[i]);
        program.setInt(kClassOfLocation + s, out.plan.classOf[i]);
    }
    out.first.bindImage(kMedium0Image, GL_WRITE_ONLY);
    if (out.second) out.second.bindImage(kMedium1Image, GL_WRITE_ONLY);
    program.dispatch(volume.grid.size);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void bakeSkylight(const VolumeTextures& volume, gl::ProgramCache& programs, MediumTextures& out) {
    const gl::Program& program = programs.get("medium/bake_skylight.comp", defines(out));
    (out.second ? out.second : out.first).bindImage(kSkylightImage, GL_READ_WRITE);
    if (out.second) out.first.bind(kMedium0Unit);
    program.setFloat(kSkylightLayerLocation, static_cast<float>(volume.grid.spacingM.z));
    program.setFloat(kSkylightAsymmetryLocation, kSkylightAsymmetry);
    program.setFloat(kSkylightGroundLocation, kGroundShare);
    program.dispatch({volume.grid.size.x, volume.grid.size.y, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

gl::Texture makeMediumTexture(glm::ivec3 size) {
    gl::Texture texture = gl::Texture::make3D(GL_RGBA32F, size);
    texture.setLinear();
    return texture;
}

}  // namespace

void bakeMedium(const VolumeTextures& volume, const MediumPlan& plan, gl::ProgramCache& programs,
                MediumTextures& out) {
    const bool sameSize = out.first && out.first.size() == volume.grid.size;
    const bool needsSecond = plan.classes.size() > kClassesBesideSkylight;
    if (!sameSize) out = {};
    out.plan = plan;
    if (!out.first) out.first = makeMediumTexture(volume.grid.size);
    if (needsSecond != static_cast<bool>(out.second)) {
        out.second = needsSecond ? makeMediumTexture(volume.grid.size) : gl::Texture();
    }
    for (gl::Texture* texture : {&out.first, &out.second}) {
        if (*texture) texture->setRepeatAcross(plan.repeats);
    }
    bakeExtinction(volume, programs, out);
    bakeSkylight(volume, programs, out);
    out.first.bind(kMedium0Unit);
    if (out.second) out.second.bind(kMedium1Unit);
    const gl::Texture maxima = gl::Texture::make3D(GL_R32F, brickCount(volume.grid.size));
    maxima.bindImage(kBrickMaximumImage, GL_WRITE_ONLY);
    std::vector<std::string> bricked = defines(out);
    bricked.push_back(fmt::format("PERIODIC {}", plan.repeats ? 1 : 0));
    const gl::Program& program = programs.get("medium/brick_maximum.comp", bricked);
    program.dispatch(maxima.size());
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    out.bricks = mapBricks(readBack(maxima), volume.grid, kInvisibleDepth);
}

}  // namespace neph::render
