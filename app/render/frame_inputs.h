// frame_inputs.h: the plain values that one picture is a function of, and what came of it.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/camera.h"
#include "core/look.h"

namespace neph::render {

struct FrameInputs {
    Look look;
    Camera camera;
    glm::ivec2 sizePx{640, 480};
    int planes = 0;  ///< 0: as the look says; interactive frames may ask for fewer
};

/// What the last frame did, for the status line and for `bench`.
struct FrameStats {
    bool bakedMedium = false;
    bool marchedLight = false;
    bool marchedEye = false;
    int planes = 0;
    glm::ivec2 lightSizePx{0};
    double milliseconds = 0.0;  ///< wall time with the GPU finished
};

}  // namespace neph::render
