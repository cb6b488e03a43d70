// noise_texture.cpp: one dispatch, once.
#include "app/render/noise_texture.h"

namespace neph::render {

gl::Texture bakeNoiseTexture(gl::ProgramCache& programs) {
    gl::Texture noise = gl::Texture::make3D(GL_RG16, glm::ivec3(kNoiseSize));
    noise.setLinear();
    noise.setRepeat();
    noise.bindImage(0, GL_WRITE_ONLY);
    programs.get("pass/bake_noise.comp").dispatch(noise.size());
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    return noise;
}

}  // namespace neph::render
