// resolve.h: from scene-referred radiance to what a screen shows: exposure, tone mapping and sRGB.
#pragma once
#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/frame/frame_inputs.h"
#include "core/image/image.h"

namespace neph::render {

/// Image units that it uses, from 0.
inline constexpr int kResolveImages = 3;

/// Fills `display` (RGBA8, of the size of `linear`, made where it has another) with `linear`
/// (RGBA32F) in the tones of `inputs`. `sunShown` (R32F, 1 x 1): share of the sun's disc that is
/// seen, for the glare in the lens.
void resolve(const gl::Texture& linear, const gl::Texture& sunShown, const FrameInputs& inputs,
             gl::ProgramCache& programs, gl::Texture& display);

/// Waits for it; row 0 on top.
Image8 readRgba8(const gl::Texture& display);

}  // namespace neph::render
