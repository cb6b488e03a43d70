// layout.h: where everything stands in the window: menu on top, a column each side, the time and
// the status along the bottom, and the picture in what is left.
//
// Pixels of ImGui, row 0 on top. Sizes are in letters (the height of the font), so that they follow
// the scale. Where the window is too narrow for both columns and a picture, the one opened last has
// the place.
#pragma once
#include <glm/glm.hpp>

namespace neph::ui {

struct Ui;

/// How wide the columns are; whether they are open is in the settings.
struct Columns {
    float leftEms = 20.0f, rightEms = 20.0f;
    bool leftLast = false;  ///< the left one was opened after the right one
};

struct Area {
    glm::vec2 lower{0.0f}, upper{0.0f};  ///< corners; `upper` is outside
    glm::vec2 size() const { return upper - lower; }
    bool empty() const { return upper.x <= lower.x || upper.y <= lower.y; }
};

struct Layout {
    Area menu, left, right, time, status, picture;  ///< empty: not there
    Area leftEdge, rightEdge;                       ///< beside the columns: drag, click
};

/// Of a frame with the window and the font that ImGui has now.
Layout layoutOf(const Ui& ui);

/// Whether there is anything to play: times or a camera path.
bool hasTimeBar(const Ui& ui);

}  // namespace neph::ui
