// blue_noise.h: a tile of numbers in which neighbours differ as much as possible.
//
// Offsets taken from it move the error of sparse sampling to high frequencies, which the eye hardly
// sees. kBlueNoiseSize squared, row by row; repeats seamlessly.
#pragma once
#include <vector>

namespace neph {

#include "shaders/shared/sizes.glsl"

/// (rank + 0.5) / 4096, each rank once: below any threshold t lies a fraction t of the places,
/// evenly distributed. The same on every machine. [Ulichney93]
const std::vector<float>& blueNoise();

}  // namespace neph
