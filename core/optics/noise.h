// noise.h: the detail noise of shaders/lib/noise.glsl, baked on the CPU.
//
// The renderer bakes the same textures with a compute pass; tests compare the two.
#pragma once
#include "core/grid/grid.h"

namespace neph {

/// Billow for liquid, wisp for ice. docs/physics.md §8
enum class NoiseCharacter : int { billow, wisp };

/// One tile of noise, size³ samples at voxel centres, values in [0, 1]; periodic along every axis.
Array3f bakeNoise(NoiseCharacter character, int size);

}  // namespace neph
