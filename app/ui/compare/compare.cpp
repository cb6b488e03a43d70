// compare.cpp: the line between two images, their labels, peeking, and images alternately.
#include "app/ui/compare/compare.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/ui/compare/compare_figures.h"
#include "app/ui/widgets/image_label.h"
#include "app/ui/widgets/places.h"

namespace neph::ui {
namespace {

constexpr double kTurnS = 0.5;   // of each image where they are alternately
constexpr float kGripPx = 9.0f;  // width that the mouse takes for the line, at a scale of 1
constexpr ImU32 kLine = IM_COL32(255, 255, 255, 200);

/// An invisible window over the line takes the mouse for it.
void dragLine(CompareState& compare, const Area& area) {
    const float at = area.lower.x + compare.splitAt * area.size().x;
    const float grip = kGripPx * ImGui::GetFontSize() / 14.0f;
    ImGui::SetNextWindowPos({at - grip / 2.0f, area.lower.y});
    ImGui::SetNextWindowSize({grip, area.upper.y - area.lower.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    if (ImGui::Begin("##split", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus)) {
        ImGui::InvisibleButton("##line", {grip, area.upper.y - area.lower.y});
        place("compare.line");
        if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
            ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        }
        if (ImGui::IsItemActive()) {
            const float share = (ImGui::GetIO().MousePos.x - area.lower.x) / area.size().x;
            compare.splitAt = std::clamp(share, 0.02f, 0.98f);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::GetBackgroundDrawList()->AddLine({at, area.lower.y}, {at, area.upper.y}, kLine, 1.5f);
}

/// Shift alone, while nothing else is done with it.
void updatePeeking(CompareState& compare) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool otherKey = std::ranges::count(io.KeysDown, true) > 1;
    compare.peeking = compare.second && compare.mode == CompareMode::single && io.KeyShift &&
                      !io.KeyCtrl && !io.WantTextInput && !otherKey && !ImGui::IsAnyMouseDown() &&
                      !ImGui::IsAnyItemActive();
}

void takeTurns(CompareState& compare, NextFrame& next) {
    const double turns = ImGui::GetTime() / kTurnS;
    compare.flickered = static_cast<int>(std::fmod(turns, 2.0));
    next.again(kTurnS * (std::floor(turns) + 1.0 - turns));
}

/// "A", or "A  mem03".
std::string badge(const CompareState& compare, std::size_t slot) {
    const std::string& member = compare.members.at(slot);
    return (slot == 0 ? "A" : "B") + (member.empty() ? "" : "  " + member);
}

}  // namespace

void drawCompare(const PanelContext& context, CompareState& compare, CompareErrors& errors) {
    updatePeeking(compare);
    if (!compare.second) return;
    if (compare.mode == CompareMode::flicker) takeTurns(compare, context.next);
    drawCompareErrors(context, compare, errors);
    if (compare.mode == CompareMode::error && errors.texture != 0) return;  // it has a legend
    const Area area = context.layout().image;
    const float margin = 0.6f * ImGui::GetFontSize();
    const float top = area.lower.y + margin;
    if (compare.mode == CompareMode::split) {
        dragLine(compare, area);
        const float at = area.lower.x + compare.splitAt * area.size().x;
        imageLabel(badge(compare, 0).c_str(), {at - margin, top}, 1.0f, compare.active == 0);
        imageLabel(badge(compare, 1).c_str(), {at + margin, top}, 0.0f, compare.active == 1);
        return;
    }
    imageLabel(badge(compare, static_cast<std::size_t>(seenSlot(compare))).c_str(),
               {area.lower.x + area.size().x / 2.0f, top}, 0.5f, !compare.peeking);
}

}  // namespace neph::ui
