// resolve.cpp: one pass, and the way back.
#include "app/render/resolve.h"

#include "app/render/frame/rows.h"
#include "core/look/exposure.h"
#include "core/look/sun.h"

namespace neph::render {

#include "shaders/shared/display_layout.glsl"

namespace {

/// The glare is of the screen alone: there is none over what is transparent.
void setGlare(const FrameInputs& inputs, const gl::Program& program) {
    const Camera& camera = inputs.camera;
    const glm::ivec2 wholePx = inputs.part ? inputs.part->wholePx : inputs.sizePx;
    const glm::vec3 glare =
        inputs.backdrop ? glareOf(inputs.look, camera.eyeWorld.z) : glm::vec3(0.0f);
    program.setVec3(kResolveGlareLocation, glare);
    program.setVec3(kResolveForwardLocation, glm::vec3(camera.forward));
    program.setVec3(kResolveRightLocation,
                    glm::vec3(camera.right * camera.tanHalfFovY * camera.aspect));
    program.setVec3(kResolveUpLocation, glm::vec3(camera.up * camera.tanHalfFovY));
    program.setVec3(kResolveTowardsSunLocation,
                    glm::vec3(discDirWorld(inputs.look, camera.eyeWorld.z)));
    program.setIvec2(kResolveWholeLocation, wholePx);
}

}  // namespace

void resolve(const gl::Texture& linear, const gl::Texture& sunShown, const FrameInputs& inputs,
             gl::ProgramCache& programs, gl::Texture& display) {
    if (display.size() != linear.size()) {
        display = gl::Texture::make2D(GL_RGBA8, glm::ivec2(linear.size()));
        display.setLinear();
    }
    const gl::Program& program = programs.get("display/resolve.comp");
    const glm::ivec2 lowerPx = inputs.part ? inputs.part->lowerPx : glm::ivec2(0);
    program.setInt(kResolveLeftLocation, lowerPx.x);
    program.setInt(kResolveLowerLocation, lowerPx.y);
    program.setInt(kResolveTransparentLocation, inputs.backdrop ? 0 : 1);
    const DisplayTones tones = displayTones(inputs.look);
    program.setMat3(kResolveExposureLocation, tones.exposure);
    program.setInt(kResolveCurveLocation, tones.curve);
    setGlare(inputs, program);
    sunShown.bindImage(kResolveSunShownImage, GL_READ_ONLY);
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
