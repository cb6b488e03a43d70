// input.cpp: tooltips as wide as all others.
#include "app/ui/widgets/input.h"

#include <imgui_internal.h>  // what has the keyboard next

namespace neph::ui {
namespace {

constexpr float kTooltipEms = 26.0f;

}  // namespace

void tooltip(const std::string& text) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * kTooltipEms);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool inputUnsettled() {
    const ImGuiContext& gui = *GImGui;
    return gui.NavMoveSubmitted || gui.NavNextActivateId != 0 ||
           (gui.WantTextInputNextFrame == 1) != gui.IO.WantTextInput;
}

}  // namespace neph::ui
