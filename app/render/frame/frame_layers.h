// frame_layers.h: what an engine may know of an image besides its colours.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/grid/species.h"
#include "core/image/image.h"

namespace neph::render {

/// Row 0 is the top row; one value per pixel.
struct FrameLayers {
    glm::ivec2 size{0};
    int samples = 0;      ///< per pixel, both halves together
    ImageF halfA, halfB;  ///< means of even and of odd samples: independent of each other
    std::vector<glm::vec3> varianceOfMean;  ///< square of the standard error
    std::vector<float> transmittance;       ///< of the ray through the pixel's middle
    std::vector<float> firstScatterM;  ///< mean distance from the eye to the first scattering of
                                       ///< the paths that have one; infinite where none has
    /// Optical depth of each species along the ray through the pixel's middle.
    std::array<std::vector<float>, kSpeciesCount> opticalDepth;
};

}  // namespace neph::render
