// dialogue.cpp: sizes follow the text and end at the window.
#include "app/ui/widgets/dialogue.h"

#include <imgui.h>

#include <algorithm>

namespace neph::ui {

glm::vec2 dialogueRoom() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    return glm::max(glm::vec2(display.x, display.y) - em, glm::vec2(em));
}

float dialogueWidth(float ems) {
    return std::min(ems * ImGui::GetFontSize(), dialogueRoom().x);
}

float itemWidth(float ems, float besideEms) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float em = ImGui::GetFontSize();
    const float edges = 2.0f * style.WindowPadding.x + style.ScrollbarSize;
    return std::clamp(dialogueRoom().x - edges - besideEms * em, em, ems * em);
}

void nextDialogue(float widthPx) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const glm::vec2 room = dialogueRoom();
    ImGui::SetNextWindowPos({display.x / 2.0f, display.y / 2.0f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({widthPx, 0.0f},
                                        {widthPx > 0.0f ? widthPx : room.x, room.y});
}

bool beginModal(const char* title, float widthPx) {
    nextDialogue(widthPx);
    return ImGui::BeginPopupModal(title, nullptr,
                                  ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings);
}

void beside(const char* label, float widthPx, float more) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = widthPx > 0.0f ? widthPx : dialogueRoom().x;
    const float around = more > 0.0f ? more : 2.0f * style.FramePadding.x;
    const float right = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + style.ItemSpacing.x +
                        ImGui::CalcTextSize(label, nullptr, true).x + around;
    if (right <= width - style.WindowPadding.x - style.ScrollbarSize) ImGui::SameLine();
}

}  // namespace neph::ui
