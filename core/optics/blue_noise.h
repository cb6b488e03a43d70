// blue_noise.h: a tile of numbers in which neighbours differ as much as possible.
//
<<<<<<< HEAD
// Offsets taken from it move the error of sparse sampling to high frequencies, which the eye hardly
// sees. 64 x 64, row by row; repeats seamlessly.
=======
// Offsets taken from it spread the error of sparse sampling over frequencies that the eye hardly
// sees. kBlueNoiseSize squared, row by row; repeats without a seam.
>>>>>>> d5884bd2975ae8c42eece443e85470d28ce49255
#pragma once
#include <vector>

namespace neph {

#include "shaders/shared/sizes.glsl"

/// (rank + 0.5) / 4096, each rank once: below any threshold t lies a fraction t of the places,
/// evenly distributed. The same on every machine. [Ulichney93]
const std::vector<float>& blueNoise();

}  // namespace neph
