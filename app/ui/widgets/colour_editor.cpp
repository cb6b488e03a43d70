// colour_editor.cpp: a swatch, and a popup with the screen's numbers (sRGB) and those that are
// stored (linear).
#include "app/ui/widgets/colour_editor.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/ui/widgets/input.h"
#include "app/ui/widgets/number_slider.h"
#include "core/base/number_text.h"
#include "core/look/colours.h"

namespace neph::ui {
namespace {

constexpr float kPickerEms = 13.0f;
constexpr float kLabelEms = 6.6f;

ImU32 onScreen(const glm::vec3& linear) {
    const glm::vec3 srgb = srgbFromLinear(glm::clamp(linear, 0.0f, 1.0f));
    return ImGui::GetColorU32(ImVec4{srgb.r, srgb.g, srgb.b, 1.0f});
}

void label(const char* text, const char* help) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text);
    tooltip(help);
    ImGui::SameLine(kLabelEms * ImGui::GetFontSize());
    ImGui::SetNextItemWidth((kPickerEms - kLabelEms + 1.5f) * ImGui::GetFontSize());
}

bool pickOnScreen(glm::vec3& linear) {
    glm::vec3 srgb = srgbFromLinear(linear);
    ImGui::SetNextItemWidth(kPickerEms * ImGui::GetFontSize());
    bool changed =
        ImGui::ColorPicker3("##picker", &srgb.x,
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoInputs |
                                ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_NoTooltip);
    label("sRGB", "As on screens and web pages: encoded, 8 bits per channel");
    changed |=
        ImGui::ColorEdit3("##hex", &srgb.x,
                          ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_InputRGB |
                              ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_NoSmallPreview |
                              ImGuiColorEditFlags_NoTooltip);
    if (changed) linear = glm::clamp(linearFromSrgb(srgb), 0.0f, 1.0f);
    return changed;
}

bool typeLinear(glm::vec3& linear) {
    constexpr std::array<const char*, 3> kLabels{"Linear red", "Linear green", "Linear blue"};
    bool changed = false;
    for (int i = 0; i < 3; ++i) {
        const char* name = kLabels.at(static_cast<std::size_t>(i));
        label(name, "As presets and --set have it: proportional to light");
        auto value = static_cast<double>(linear[i]);
        if (!numberSlider(name, value, {0.0, 1.0}, numberText(value, 3), "")) continue;
        linear[i] = static_cast<float>(value);
        changed = true;
    }
    return changed;
}

}  // namespace

bool colourPicker(glm::vec3& linear) {
    const bool picked = pickOnScreen(linear);
    return typeLinear(linear) || picked;
}

void fillWithColour(glm::vec2 lower, glm::vec2 upper, const glm::vec3& linear) {
    const float rounding = ImGui::GetStyle().FrameRounding;
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled({lower.x, lower.y}, {upper.x, upper.y}, onScreen(linear), rounding);
    list->AddRect({lower.x, lower.y}, {upper.x, upper.y},
                  ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.6f), rounding);
}

bool colourEditor(const char* id, glm::vec3& linear) {
    ImGui::PushID(id);
    const ImVec2 lower = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(1.0f, ImGui::CalcItemWidth()), ImGui::GetFrameHeight()};
    if (ImGui::InvisibleButton("##swatch", size)) ImGui::OpenPopup("##colour");
    fillWithColour({lower.x, lower.y}, {lower.x + size.x, lower.y + size.y}, linear);
    bool changed = false;
    if (ImGui::BeginPopup("##colour")) {
        changed = colourPicker(linear);
        ImGui::EndPopup();
    }
    ImGui::PopID();
    return changed;
}

}  // namespace neph::ui
