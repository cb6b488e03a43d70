// fixed_window.cpp: place, size and what such a window has none of.
#include "app/ui/widgets/fixed_window.h"

namespace neph::ui {

bool beginFixed(const char* name, glm::vec2 at, glm::vec2 size, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos({at.x, at.y});
    ImGui::SetNextWindowSize({size.x, size.y});
    return ImGui::Begin(name, nullptr,
                        flags | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                            ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoCollapse |
                            ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                            ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus);
}

}  // namespace neph::ui
