// noise_texture.h: the detail noises of shaders/lib/noise.glsl as a texture.
#pragma once
#include "app/gl/objects.h"
#include "app/gl/program.h"

namespace neph::render {

/// Texels a side of the tile.
inline constexpr int kNoiseSize = 128;

/// RG16, repeating. r: billow, g: wisp.
gl::Texture bakeNoiseTexture(gl::ProgramCache& programs);

}  // namespace neph::render
