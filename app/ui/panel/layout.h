// layout.h: where everything stands in the window: menu on top, a column each side, the time and
// the status along the bottom, and the image in what is left.
//
// Pixels of ImGui, row 0 on top. Sizes are in letters (the height of the font), so that they follow
// the scale. Where the window is too narrow for both columns and an image, the one opened last has
// the place.
#pragma once
#include "app/ui/widgets/area.h"
#include "core/grid/boxes.h"
#include "core/session/session.h"
#include "core/session/settings.h"

namespace neph::ui {

/// What of the columns is not kept in the settings.
struct Columns {
    bool shown = true;  ///< with menus, time bar and status line; else the image has all the window
    bool leftLast = false;  ///< the left one was opened after the right one
};

struct Layout {
    Area menu, left, right, time, status, image;  ///< empty: not there
    Area leftEdge, rightEdge;                     ///< beside the columns: drag, click
};

/// Of a frame with the window and the font that ImGui has now.
Layout layoutOf(const Session& session, const Settings& settings, const Columns& columns);

/// Opens or closes a column. In a window too narrow for both, the one opened last is shown.
void openColumn(Settings& settings, Columns& columns, bool left, bool open);

/// Whether there is anything to play: times or a camera path.
bool hasTimeBar(const Session& session);

/// Where the image is in the window's framebuffer: all that the panels leave. At least a pixel.
PixelBox imageBox(const Layout& layout);

}  // namespace neph::ui
