// input.h: what panels ask of ImGui's last item and of the keyboard.
#pragma once
#include <imgui.h>

#include <string>

namespace neph::ui {

/// A tooltip for the last item, disabled or not, in lines that are easy to read.
void tooltip(const std::string& text);

/// Whether ImGui needs another frame before it takes keys as what is on the screen suggests: a line
/// that is about to have the keyboard, or has just given it up.
bool inputUnsettled();

/// Whether a key went down in this frame, or repeats.
inline bool pressed(ImGuiKey key) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

}  // namespace neph::ui
