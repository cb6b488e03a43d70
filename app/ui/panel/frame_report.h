// frame_report.h: what is known of the image on screen: how it was made, of what and how fast.
#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "core/image/light_progress.h"
#include "core/image/measured_error.h"
#include "core/image/reference_progress.h"
#include "core/look/look.h"

namespace neph::ui {

/// The image on screen, for the status line.
struct FrameReport {
    double milliseconds = 0.0;
    Engine engine{};
    int planes = 0;   ///< slices, or steps of the march along the diagonal
    int samples = 0;  ///< images that were averaged
    glm::ivec2 sizePx{0};
    bool full = false;  ///< at the resolution of the window and with all planes or steps
    std::string device;
    std::size_t gpuBytes = 0;     ///< held for this slot's images
    int time = -1;                ///< of the data in it; -1: not told
    ReferenceProgress reference;  ///< of that engine alone
    int previewSamples = 0;  ///< of each pixel, of which a denoised preview is shown; 0: none is
    std::optional<LightProgress> light;  ///< of full transport
    std::string knownError;              ///< of other transport: core/look/known_error.h
    std::optional<MeasuredError> error;  ///< against the reference; none before it was measured
    bool measuring = false;              ///< the error, or a better one, is being measured
};

}  // namespace neph::ui
