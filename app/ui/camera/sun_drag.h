// sun_drag.h: the sun under the mouse: its disc in the image, and where it stands on the compass
// rose.
//
// On the rose a sun by date keeps to its path of the day, and a drag sets the hour; a sun by angles
// goes anywhere. So does the disc, which is by angles from then on, as is a sun whose date is that
// of the data. Escape returns it.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "app/ui/panel/panel_context.h"

namespace neph::ui {

enum class SunHandle { none, rose, disc };

/// What lasts from frame to frame.
struct SunDrag {
    SunHandle hovered = SunHandle::none;
    SunHandle held = SunHandle::none;
    bool given = false;     ///< the button is down still, and no longer the camera's
    glm::vec2 toSun{0.0f};  ///< from the mouse to what it holds, pixels
    SunSource source{};     ///< before the drag, as are the others
    float azimuthDeg = 0.0f, elevationDeg = 0.0f, hour = 0.0f;

    SunHandle lit() const { return held == SunHandle::none ? hovered : held; }
};

/// Once per frame, before the camera moves; names their places sun.rose and sun.disc. What the
/// button holds is not the camera's. `may`: it can be taken, because the mouse does nothing else.
void dragSun(const PanelContext& context, SunDrag& drag, bool may);

/// Where the middle of the sun's disc is in the image, pixels of ImGui; none where it is beside the
/// image or below the horizon of the ground.
std::optional<glm::vec2> sunInImage(const PanelContext& context);

/// How far from the middle the mouse takes it, pixels: 12 in letters of the usual size.
float sunReach();

/// "Sun: azimuth 250.1°, elevation 23.4°, 21:45 UTC", the time of a sun by date.
std::string sunWords(const Session& session);

}  // namespace neph::ui
