// window_fit.cpp: sizes first, then places.
#include "app/workbench/window_fit.h"

namespace neph {

ScreenBox fitOn(const ScreenBox& area, ScreenBox window, const WindowFrame& frame) {
    const glm::ivec2 most = glm::max(area.size - frame.before - frame.after, glm::ivec2(1));
    window.size = glm::min(window.size, most);
    const glm::ivec2 first = area.at + frame.before;
    window.at = glm::clamp(window.at, first, first + most - window.size);
    return window;
}

glm::ivec2 leastOn(const ScreenBox& area, glm::ivec2 least, const WindowFrame& frame) {
    return fitOn(area, {area.at, least}, frame).size;
}

int sharedArea(const ScreenBox& a, const ScreenBox& b) {
    const glm::ivec2 shared = glm::min(a.at + a.size, b.at + b.size) - glm::max(a.at, b.at);
    return shared.x > 0 && shared.y > 0 ? shared.x * shared.y : 0;
}

}  // namespace neph
