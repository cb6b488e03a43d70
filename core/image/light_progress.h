// light_progress.h: how far full transport has come with the light of an image: one set of figures
// for the renderer, the window, the commands and their files. docs/transport.md
#pragma once
#include <glm/glm.hpp>

namespace neph {

/// How far full transport has come with the light of the last frame.
struct LightProgress {
    int cycles = 0;              ///< of the solver, for the sun
    bool settled = false;        ///< it gets no better
    double remaining = 1.0;      ///< relative size of the last correction on the coarsest grid
    double chance = -1.0;        ///< relative noise of the averaged cycles; negative: not known
    double underResolved = 0.0;  ///< share of the caught sunlight that voxels are too thick for
    glm::ivec3 voxels{0};
    glm::dvec3 voxelM{0.0};
};

}  // namespace neph
