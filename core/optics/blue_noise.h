// blue_noise.h: a tile of numbers whose neighbours differ as much as they can.
//
// Offsets taken from it spread the error of sparse sampling over frequencies that the eye hardly
// sees. kBlueNoiseSize squared, row by row; repeats without a seam.
#pragma once
#include <vector>

namespace neph {

#include "shaders/shared/sizes.glsl"

/// (rank + 0.5) / 4096, each rank once: below any threshold t lie a share t of the places, spread
/// evenly. The same on every machine. [Ulichney93]
const std::vector<float>& blueNoise();

}  // namespace neph
