// history_panel.cpp: the steps of the history, oldest first; a click goes there.
#include "app/ui/shell/history_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/widgets/dialogue.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"

namespace neph::ui {
namespace {

constexpr float kWidthEms = 24.0f, kHeightEms = 22.0f;

/// A step; those that were undone are dim. True when it is to be gone to.
bool drawStep(std::size_t index, std::size_t now, const std::string& label) {
    ImGui::PushID(static_cast<int>(index));
    const ImGuiCol colour = index > now ? ImGuiCol_TextDisabled : ImGuiCol_Text;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(colour));
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool chosen = ImGui::Selectable(label.c_str(), index == now);
    ImGui::PopStyleColor(2);
    place(fmt::format("history:{}", index));
    const bool cut = ImGui::CalcTextSize(label.c_str()).x > ImGui::GetItemRectSize().x;
    if (cut) tooltip(label);
    ImGui::PopID();
    return chosen;
}

void drawSteps(Session& session, std::size_t& seen) {
    const std::vector<std::string> steps = session.history.steps();
    const std::size_t now = session.history.position();
    std::size_t wanted = now;
    for (std::size_t i = 0; i <= steps.size(); ++i) {
        if (drawStep(i, now, i == 0 ? "Start" : steps[i - 1])) wanted = i;
    }
    // The present one is followed, but not while somebody looks for another.
    if (now != seen) {
        const float line = ImGui::GetTextLineHeightWithSpacing();
        ImGui::SetScrollY(static_cast<float>(now) * line - ImGui::GetWindowHeight() / 2.0f);
        seen = now;
    }
    if (wanted != now) session.jumpTo(wanted);
}

}  // namespace

void drawHistory(Session& session, bool& shown, std::size_t& seen) {
    const float em = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSize(
        {dialogueWidth(kWidthEms), std::min(kHeightEms * em, dialogueRoom().y)},
        ImGuiCond_Appearing);
    ImGui::SetNextWindowPos({display.x / 2.0f, display.y / 2.0f}, ImGuiCond_Appearing,
                            {0.5f, 0.5f});
    const auto flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("History", &shown, flags)) {
        drawSteps(session, seen);
    }
    ImGui::End();
}

}  // namespace neph::ui
