// noise_texture.cpp: baked once. Processors compute both sides of a branch, so each noise of the
// stack is a dispatch of its own.
#include "app/render/noise_texture.h"

#include <string>
#include <vector>

namespace neph::render {
namespace {

gl::Texture make(GLenum format, glm::ivec3 size, int levels) {
    gl::Texture noise = gl::Texture::make3D(format, size, levels);
    noise.setRepeat();
    noise.bindImage(0, GL_WRITE_ONLY);
    return noise;
}

void bake(gl::ProgramCache& programs, const std::vector<std::string>& defines) {
    programs.get("pass/bake_noise.comp", defines).dispatch(glm::ivec3(kNoiseSize));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

}  // namespace

gl::Texture bakeNoise(gl::ProgramCache& programs) {
    gl::Texture noise = make(GL_RG16, glm::ivec3(kNoiseSize), 1);
    bake(programs, {"STACKED 0"});
    noise.setLinear();
    return noise;
}

gl::Texture bakeStackedNoise(gl::ProgramCache& programs) {
    gl::Texture noise = make(GL_R8, {kNoiseSize, kNoiseSize, 2 * kNoiseSize}, kNoiseLevels);
    bake(programs, {"STACKED 1", "WISP 0"});
    bake(programs, {"STACKED 1", "WISP 1"});
    noise.makeLevels();
    return noise;
}

}  // namespace neph::render
