// resolve.cpp: one pass, and the way back.
#include "app/render/resolve.h"

#include "app/render/frame/rows.h"
#include "core/look/exposure.h"

namespace neph::render {

#include "shaders/shared/display_layout.glsl"

void resolve(const gl::Texture& linear, const FrameInputs& inputs, gl::ProgramCache& programs,
             gl::Texture& display) {
    if (display.size() != linear.size()) {
        display = gl::Texture::make2D(GL_RGBA8, glm::ivec2(linear.size()));
        display.setLinear();
    }
    const gl::Program& program = programs.get("display/resolve.comp");
    const glm::ivec2 lowerPx = inputs.part ? inputs.part->lowerPx : glm::ivec2(0);
    program.setInt(kResolveLeftLocation, lowerPx.x);
    program.setInt(kResolveLowerLocation, lowerPx.y);
    program.setInt(kResolveTransparentLocation, inputs.backdrop ? 0 : 1);
    program.setFloat(kResolveGainLocation, exposureGain(inputs.look));
    program.setInt(kResolveCurveLocation, static_cast<int>(inputs.look.toneMap));
    linear.bindImage(kResolveLinearImage, GL_READ_ONLY);
    display.bindImage(kResolveDisplayImage, GL_WRITE_ONLY);
    program.dispatch(display.size());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

Image8 readRgba8(const gl::Texture& display) {
    Image8 image;
    image.size = glm::ivec2(display.size());
    const std::size_t stride = 4 * static_cast<std::size_t>(image.size.x);
    std::vector<std::uint8_t> rows(stride * static_cast<std::size_t>(image.size.y));
    if (rows.empty()) return image;
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(display.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(rows.size()), rows.data());
    image.rgba = fromTop(rows, stride);
    return image;
}

}  // namespace neph::render
