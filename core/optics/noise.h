// noise.h: the detail noise of shaders/lib/noise.glsl, baked on the CPU.
//
// The renderer bakes the same textures with a compute pass; this is what tests hold it to.
#pragma once
#include "core/grid/grid.h"

namespace neph {

enum class NoiseCharacter : int { billow, wisp };

/// One tile of noise, size³ samples at voxel centres, values in [0, 1]; repeats in every axis.
Array3f bakeNoise(NoiseCharacter character, int size);

}  // namespace neph
