// noise_texture.cpp: one dispatch, once.
#include "app/render/noise_texture.h"

namespace neph::render {
namespace {

gl::Texture bake(gl::ProgramCache& programs, GLenum format, glm::ivec3 size, int levels,
                 const char* stacked) {
    gl::Texture noise = gl::Texture::make3D(format, size, levels);
    noise.setRepeat();
    noise.bindImage(0, GL_WRITE_ONLY);
    programs.get("pass/bake_noise.comp", {stacked}).dispatch(size);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    return noise;
}

}  // namespace

gl::Texture bakeNoise(gl::ProgramCache& programs) {
    gl::Texture noise = bake(programs, GL_RG16, glm::ivec3(kNoiseSize), 1, "STACKED 0");
    noise.setLinear();
    return noise;
}

gl::Texture bakeStackedNoise(gl::ProgramCache& programs) {
    gl::Texture noise =
        bake(programs, GL_R8, {kNoiseSize, kNoiseSize, 2 * kNoiseSize}, kNoiseLevels, "STACKED 1");
    noise.makeLevels();
    return noise;
}

}  // namespace neph::render
