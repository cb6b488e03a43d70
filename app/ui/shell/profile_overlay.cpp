// profile_overlay.cpp: what the image cost, over its corner: text, and a thin bar under each
// pass.
//
// Digits of the font are of one width, so numbers that end at the same place stand still.
#include "app/ui/shell/profile_overlay.h"

#include <imgui.h>

#include <algorithm>

namespace neph::ui {
namespace {

// In letters: width, margin to the image's edge, and where values end.
constexpr float kWidthEms = 19.0f, kMarginEms = 0.7f, kValueEndEms = 12.0f;
constexpr float kOpacity = 0.80f;  // legible on a bright cloud, and the cloud still shows

/// Nearer to that of values than on the panels, since the image shows through.
ImVec4 labelColour() {
    const ImVec4 text = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    const ImVec4 label = ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
    return {(text.x + label.x) / 2.0f, (text.y + label.y) / 2.0f, (text.z + label.z) / 2.0f, 1.0f};
}

void textUpTo(float end, const std::string& text, bool dim) {
    ImGui::SameLine(end - ImGui::CalcTextSize(text.c_str()).x);
    dim ? ImGui::TextDisabled("%s", text.c_str()) : ImGui::TextUnformatted(text.c_str());
}

void drawBar(double share) {
    const float height = 0.14f * ImGui::GetFontSize();
    const float full = ImGui::GetContentRegionAvail().x;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    canvas.AddRectFilled(at, {at.x + full, at.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    canvas.AddRectFilled(at, {at.x + static_cast<float>(share) * full, at.y + height},
                         ImGui::GetColorU32(ImGuiCol_PlotHistogram));
    ImGui::Dummy({full, height});
}

void drawRow(const ProfileRow& row) {
    const float em = ImGui::GetFontSize();
    ImGui::TextDisabled("%s", row.label.c_str());
    textUpTo(kValueEndEms * em, row.value, row.old);
    textUpTo(kWidthEms * em - ImGui::GetStyle().WindowPadding.x, row.note, true);
}

void drawRows(const std::vector<ProfileRow>& rows) {
    for (const ProfileRow& row : rows) drawRow(row);
}

void drawContent(const Profile& profile) {
    const ImVec2 gap{0.0f, 0.3f * ImGui::GetFontSize()};
    ImGui::TextUnformatted(profile.engine.c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%s", profile.device.c_str());
    drawRows(profile.image);
    if (!profile.error.empty()) {
        ImGui::TextDisabled("error");
        ImGui::TextWrapped("%s", profile.error.c_str());
    }
    ImGui::Dummy(gap);
    for (const ProfileRow& row : profile.passes) {
        drawRow(row);
        drawBar(row.share);
    }
    ImGui::Dummy(gap);
    drawRows(profile.samples);
    if (!profile.memory.empty()) drawRow(profile.memory.front());
    ImGui::TextDisabled("last change redid");
    ImGui::TextUnformatted(profile.redone.c_str());
}

}  // namespace

void drawProfile(const Area& image, const Profile& profile) {
    const float em = ImGui::GetFontSize();
    const float width = std::min(kWidthEms * em, image.size().x - 2.0f * kMarginEms * em);
    ImGui::SetNextWindowPos(
        {image.upper.x - width - kMarginEms * em, image.lower.y + kMarginEms * em});
    ImGui::SetNextWindowSize({std::max(1.0f, width), 0.0f});  // as high as the rows
    ImGui::SetNextWindowBgAlpha(kOpacity);
    ImGui::PushStyleColor(ImGuiCol_TextDisabled, labelColour());
    // Without inputs: the mouse reaches the image through it.
    if (ImGui::Begin("##profile", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_NoBringToFrontOnFocus)) {
        if (profile.image.empty()) {
            ImGui::TextDisabled("No image yet");
        } else {
            drawContent(profile);
        }
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace neph::ui
