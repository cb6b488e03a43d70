// reference_layers.h: what the engine `reference` knows of a picture besides its colours.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/grid/species.h"
#include "core/image/image.h"

namespace neph::render {

/// Row 0 is the top row; a value a pixel.
struct ReferenceLayers {
    glm::ivec2 size{0};
    int samples = 0;      ///< paths a pixel, both halves together
    ImageF halfA, halfB;  ///< means of the even and of the odd paths: independent of each other
    std::vector<glm::vec3> varianceOfMean;  ///< square of the standard error
    std::vector<float> transmittance;       ///< of the ray through the pixel's middle
    std::vector<float> firstScatterM;  ///< mean distance from the eye to the first scattering of
                                       ///< the paths that have one; infinite where none has
    /// Optical depth of each species along the ray through the pixel's middle.
    std::array<std::vector<float>, kSpeciesCount> opticalDepth;
};

}  // namespace neph::render
