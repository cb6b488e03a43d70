// error_map.h: where the image on screen differs from the reference: colours in its place.
#pragma once
#include <memory>
#include <optional>
#include <span>

#include "app/ui/panel/frame_report.h"
#include "app/ui/panel/panel_context.h"
#include "core/image/error_image.h"

namespace neph::ui {

/// What an image differs by, as colours.
struct ErrorMap {
    ErrorScale scale;
    Image8 colours;  ///< of the reference's size
};

/// From errorsBeyondNoise() of an image of `sizePx`.
ErrorMap errorMapOf(glm::ivec2 sizePx, std::span<const float> errors);

/// The error of the image on screen: what is asked of the window, and what it has.
struct ErrorMeter {
    bool toggled = false;   ///< start to measure, or stop, after this frame
    bool map = false;       ///< where it is, is shown; it is measured whenever the image rests
    bool measures = false;  ///< as of the last frame; the window says so
    bool atRestByDefault = false;           ///< where the settings say nothing: on a GPU
    std::shared_ptr<const ErrorMap> found;  ///< of the image on screen
    std::shared_ptr<const ErrorMap> drawn;  ///< that `texture` shows
    unsigned texture = 0;

    bool atRest(const Settings& settings) const {
        return settings.measureAtRest.value_or(atRestByDefault);
    }
};

/// Where the map is wanted and one image is shown.
void drawErrorMap(const PanelContext& context, ErrorMeter& meter, const FrameReport& report);

}  // namespace neph::ui
