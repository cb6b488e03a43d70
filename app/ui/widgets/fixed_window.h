// fixed_window.h: borderless windows that stay where they are put.
#pragma once
#include <imgui.h>

#include <glm/glm.hpp>

namespace neph::ui {

/// Opens one, without scrolling unless `flags` say otherwise; pair with ImGui::End().
bool beginFixed(const char* name, glm::vec2 at, glm::vec2 size,
                ImGuiWindowFlags flags = ImGuiWindowFlags_NoScrollbar |
                                         ImGuiWindowFlags_NoScrollWithMouse);

}  // namespace neph::ui
