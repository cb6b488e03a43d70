// area.h: a rectangle of the window: pixels of ImGui, row 0 on top.
#pragma once
#include <glm/glm.hpp>

namespace neph::ui {

struct Area {
    glm::vec2 lower{0.0f}, upper{0.0f};  ///< corners; `upper` is outside
    glm::vec2 size() const { return upper - lower; }
    bool empty() const { return upper.x <= lower.x || upper.y <= lower.y; }
};

}  // namespace neph::ui
