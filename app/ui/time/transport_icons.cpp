// transport_icons.cpp: triangles, bars and an arc, within the last item.
#include "app/ui/time/transport_icons.h"

#include <imgui.h>

#include <glm/glm.hpp>

namespace neph::ui {
namespace {

constexpr float kPi = 3.14159265f;

/// Draws around `at`, `half` being half the height of a sign.
struct Pen {
    ImDrawList* canvas;
    ImVec2 at;
    float half;
    ImU32 colour;

    ImVec2 point(float x, float y) const { return {at.x + x * half, at.y + y * half}; }
    void triangle(float from, float to) const {
        canvas->AddTriangleFilled(point(from, -1.0f), point(from, 1.0f), point(to, 0.0f), colour);
    }
    void bar(float from, float to) const {
        canvas->AddRectFilled(point(from, -1.0f), point(to, 1.0f), colour);
    }
    void chevron(float tip, float back) const {
        const ImVec2 line[] = {point(back, -0.9f), point(tip, 0.0f), point(back, 0.9f)};
        canvas->AddPolyline(line, 3, colour, ImDrawFlags_None, 0.36f * half);
    }
    /// Most of a circle, with an arrow's head at its end.
    void turn() const {
        canvas->PathArcTo(at, 0.85f * half, -0.25f * kPi, 1.35f * kPi, 20);
        canvas->PathStroke(colour, ImDrawFlags_None, 0.3f * half);
        canvas->AddTriangleFilled(point(-0.95f, -0.95f), point(-0.1f, -1.0f), point(-0.45f, -0.2f),
                                  colour);
    }
};

void draw(const Pen& pen, Icon icon) {
    switch (icon) {
        case Icon::first:
            pen.bar(-0.9f, -0.6f);
            return pen.triangle(0.9f, -0.5f);
        case Icon::before:
            return pen.chevron(-0.45f, 0.4f);
        case Icon::play:
            return pen.triangle(-0.7f, 1.0f);
        case Icon::pause:
            pen.bar(-0.75f, -0.25f);
            return pen.bar(0.25f, 0.75f);
        case Icon::after:
            return pen.chevron(0.45f, -0.4f);
        case Icon::last:
            pen.triangle(-0.9f, 0.5f);
            return pen.bar(0.6f, 0.9f);
        case Icon::loop:
            return pen.turn();
    }
}

}  // namespace

bool iconButton(const char* id, Icon icon, float width, bool lit) {
    ImGui::PushID(id);
    if (lit) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    }
    const bool pressed = ImGui::Button("##icon", {width, 0.0f});
    if (lit) ImGui::PopStyleColor();
    ImGui::PopID();
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    draw({ImGui::GetWindowDrawList(),
          {(lower.x + upper.x) / 2.0f, (lower.y + upper.y) / 2.0f},
          0.34f * ImGui::GetFontSize(),
          ImGui::GetColorU32(ImGuiCol_Text)},
         icon);
    return pressed;
}

}  // namespace neph::ui
