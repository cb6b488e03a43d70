// window_fit.h: where a window goes so that all of it is on the screen.
//
// Screen coordinates: x to the right, y down. The frame is what the window system draws around the
// contents.
#pragma once
#include <glm/glm.hpp>

namespace neph {

/// Contents of a window, or the part of a screen that windows may take.
struct ScreenBox {
    glm::ivec2 at{0}, size{0};
    bool operator==(const ScreenBox&) const = default;
};

/// Widths of a window's frame.
struct WindowFrame {
    glm::ivec2 before{0};  ///< left and top
    glm::ivec2 after{0};   ///< right and bottom
};

/// `window` cut to fit into `area` with its frame, and moved as little as that takes.
ScreenBox fitOn(const ScreenBox& area, ScreenBox window, const WindowFrame& frame);

/// The smallest contents that are allowed: `least`, or what fits where the area is smaller.
glm::ivec2 leastOn(const ScreenBox& area, glm::ivec2 least, const WindowFrame& frame);

/// Pixels that two boxes share.
int sharedArea(const ScreenBox& a, const ScreenBox& b);

}  // namespace neph
