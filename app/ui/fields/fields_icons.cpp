// fields_icons.cpp: shapes in shares of the height of a line.
#include "app/ui/fields/fields_icons.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/widgets/colour_editor.h"

namespace neph::ui {
namespace {

constexpr int kLidPoints = 12;

struct Spot {
    ImVec2 lower, upper;
    bool clicked = false;
    ImVec2 middle() const { return {(lower.x + upper.x) / 2.0f, (lower.y + upper.y) / 2.0f}; }
};

Spot button(const char* id, float width) {
    const float height = ImGui::GetFrameHeight();
    Spot spot;
    spot.lower = ImGui::GetCursorScreenPos();
    spot.upper = {spot.lower.x + width, spot.lower.y + height};
    spot.clicked = ImGui::InvisibleButton(id, {width, height});
    if (ImGui::IsItemHovered()) {
        ImGui::GetWindowDrawList()->AddRectFilled(spot.lower, spot.upper,
                                                  ImGui::GetColorU32(ImGuiCol_FrameBgHovered),
                                                  ImGui::GetStyle().FrameRounding);
    }
    return spot;
}

ImU32 ink(bool on) {
    return ImGui::GetColorU32(on ? ImGuiCol_Text : ImGuiCol_TextDisabled);
}

/// Upper and lower lid, from corner to corner and back.
void lids(ImDrawList* list, ImVec2 middle, float halfWidth, float halfHeight, ImU32 colour) {
    for (int i = 0; i <= 2 * kLidPoints; ++i) {
        const float x = 1.0f - 2.0f * static_cast<float>(std::abs(i - kLidPoints)) / kLidPoints;
        const float side = i < kLidPoints ? -1.0f : 1.0f;
        list->PathLineTo({middle.x + x * halfWidth, middle.y + side * halfHeight * (1.0f - x * x)});
    }
    list->PathStroke(colour, ImDrawFlags_Closed, 1.3f);
}

}  // namespace

bool eyeButton(const char* id, bool open, float width) {
    const Spot spot = button(id, width);
    const float height = ImGui::GetFrameHeight();
    const ImVec2 middle = spot.middle();
    ImDrawList* list = ImGui::GetWindowDrawList();
    lids(list, middle, 0.42f * height, 0.26f * height, ink(open));
    if (open) {
        list->AddCircleFilled(middle, 0.14f * height, ink(true));
    } else {
        const float reach = 0.32f * height;
        list->AddLine({middle.x - reach, middle.y + reach}, {middle.x + reach, middle.y - reach},
                      ink(false), 1.5f);
    }
    return spot.clicked;
}

bool letterButton(const char* letter, bool lit, float width) {
    const Spot spot = button(letter, width);
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (lit) {
        list->AddRectFilled(spot.lower, spot.upper, ImGui::GetColorU32(ImGuiCol_ButtonActive),
                            ImGui::GetStyle().FrameRounding);
    }
    const ImVec2 size = ImGui::CalcTextSize(letter), middle = spot.middle();
    list->AddText({middle.x - size.x / 2.0f, middle.y - size.y / 2.0f}, ink(lit), letter);
    return spot.clicked;
}

bool chainButton(const char* id, bool closed, float width) {
    const Spot spot = button(id, width);
    const float height = ImGui::GetFrameHeight();
    const float half = 0.21f * height, thin = 0.14f * height;
    const float apart = closed ? 0.15f * height : 0.27f * height;
    const ImVec2 middle = spot.middle();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImU32 colour = ImGui::GetColorU32(closed ? ImGuiCol_CheckMark : ImGuiCol_TextDisabled);
    for (const float side : {-1.0f, 1.0f}) {
        const float x = middle.x + side * apart;
        list->AddRect({x - half, middle.y - thin}, {x + half, middle.y + thin}, colour, thin, 0,
                      1.5f);
    }
    return spot.clicked;
}

bool swatchButton(const char* id, const glm::vec3& colour, const glm::vec3& rim, float width) {
    const float height = ImGui::GetFrameHeight();
    const ImVec2 lower = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(id, {width, height});
    const float inset = std::floor(0.1f * height), band = std::floor(0.15f * height);
    const glm::vec2 from{lower.x, lower.y + inset}, to{lower.x + width, lower.y + height - inset};
    fillWithColour(from, to, rim);
    fillWithColour(from + band, to - band, colour);
    return clicked;
}

}  // namespace neph::ui
