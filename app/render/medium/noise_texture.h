// noise_texture.h: the detail noises of shaders/lib/noise.glsl as a texture; either repeats.
#pragma once
#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "core/grid/species.h"

namespace neph::render {

#include "shaders/shared/medium_layout.glsl"

/// RG16, filtered. r: billow, g: wisp. As half-angle slicing reads it.
gl::Texture bakeNoise(gl::ProgramCache& programs);

/// R8, nearest, with levels of half the size each: a tile of billow and upon it one of wisp. As the
/// march reads it: few bytes, so that more of it stays in caches. Kept as a file of the user's
/// cache, by the text of its shader, since a processor takes half a second for it.
gl::Texture bakeStackedNoise(gl::ProgramCache& programs);

}  // namespace neph::render
