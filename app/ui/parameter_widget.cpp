// parameter_widget.cpp: sliders work on the value as shown on screen and store SI.
#include "app/ui/parameter_widget.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/format.h"

namespace neph::ui {
namespace {

constexpr float kLabelShare = 0.42f;  // of the line
constexpr float kTooltipEms = 26.0f;  // width of a tooltip in letters
constexpr double kTooltipDelayS = 0.35;
constexpr std::size_t kMaxButtons = 3;  // choices shown side by side; more make a list

/// Shown once the mouse has rested on the last item for a while, and not while it is being dragged.
void tooltip(const Parameter& row) {
    static const Parameter* rested = nullptr;
    static double since = 0.0;
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const bool moved = ImGui::GetIO().MouseDelta.x != 0.0f || ImGui::GetIO().MouseDelta.y != 0.0f;
    if (rested != &row || moved || ImGui::IsAnyItemActive()) {
        rested = &row;
        since = ImGui::GetTime();
    }
    if (ImGui::GetTime() - since < kTooltipDelayS) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * kTooltipEms);
    ImGui::TextUnformatted(tooltipOf(row).c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool reset(const Parameter& row, Look& look) {
    const ParameterValue standard = defaultOf(row);
    if (valueOf(look, row) == standard) return false;
    setValue(look, row, standard);
    return true;
}

/// Menu on right click on the last item.
bool resetMenu(const Parameter& row, Look& look) {
    bool changed = false;
    if (ImGui::BeginPopupContextItem("##menu")) {
        if (ImGui::MenuItem("Reset to default")) changed = reset(row, look);
        if (ImGui::MenuItem("Copy id")) ImGui::SetClipboardText(row.id.c_str());
        if (ImGui::MenuItem("Copy id=value")) {
            const std::string text = row.id + "=" + formatValue(row, valueOf(look, row));
            ImGui::SetClipboardText(text.c_str());
        }
        ImGui::EndPopup();
    }
    return changed;
}

ImGuiSliderFlags flagsOf(const Parameter& row) {
    return ImGuiSliderFlags_AlwaysClamp | (row.range.log ? ImGuiSliderFlags_Logarithmic : 0);
}

bool editNumber(const Parameter& row, Look& look) {
    const double before = static_cast<double>(std::get<float>(valueOf(look, row)));
    auto shown = static_cast<float>(before * row.displayScale);
    const auto lo = static_cast<float>(row.range.lo * row.displayScale);
    const auto hi = static_cast<float>(row.range.hi * row.displayScale);
    if (!ImGui::SliderFloat("##value", &shown, lo, hi, sliderFormat(row).c_str(), flagsOf(row))) {
        return false;
    }
    const double si = static_cast<double>(shown) / row.displayScale;
    setValue(look, row, static_cast<float>(std::clamp(si, row.range.lo, row.range.hi)));
    return true;
}

bool editInteger(const Parameter& row, Look& look) {
    int value = std::get<int>(valueOf(look, row));
    const int lo = static_cast<int>(row.range.lo), hi = static_cast<int>(row.range.hi);
    if (!ImGui::SliderInt("##value", &value, lo, hi, sliderFormat(row).c_str(), flagsOf(row))) {
        return false;
    }
    setValue(look, row, std::clamp(value, lo, hi));
    return true;
}

/// Buttons side by side, the chosen one lit.
int chooseByButton(const Parameter& row, int chosen) {
    const float spacing = ImGui::GetStyle().ItemInnerSpacing.x / 2.0f;
    const auto count = static_cast<float>(row.choiceLabels.size());
    const float width = (ImGui::CalcItemWidth() - spacing * (count - 1.0f)) / count;
    for (int i = 0; i < static_cast<int>(row.choiceLabels.size()); ++i) {
        if (i > 0) ImGui::SameLine(0.0f, spacing);
        const bool lit = i == chosen;
        if (lit) {
            const ImVec4 accent = ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive);
            ImGui::PushStyleColor(ImGuiCol_Button, accent);
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, accent);
        }
        const std::string label(row.choiceLabels[static_cast<std::size_t>(i)]);
        if (ImGui::Button(label.c_str(), {width, 0.0f})) chosen = i;
        if (lit) ImGui::PopStyleColor(2);
    }
    return chosen;
}

int chooseFromList(const Parameter& row, int chosen) {
    const std::string current(row.choiceLabels[static_cast<std::size_t>(chosen)]);
    if (!ImGui::BeginCombo("##value", current.c_str())) return chosen;
    for (int i = 0; i < static_cast<int>(row.choiceLabels.size()); ++i) {
        const std::string label(row.choiceLabels[static_cast<std::size_t>(i)]);
        if (ImGui::Selectable(label.c_str(), i == chosen)) chosen = i;
    }
    ImGui::EndCombo();
    return chosen;
}

/// Whether the labels of a choice fit on buttons in the width of the next item.
bool fitsOnButtons(const Parameter& row) {
    if (row.choiceLabels.size() > kMaxButtons) return false;
    float widest = 0.0f;
    for (const std::string_view label : row.choiceLabels) {
        widest = std::max(widest, ImGui::CalcTextSize(label.data(), label.data() + label.size()).x);
    }
    const float button = widest + 2.0f * ImGui::GetStyle().FramePadding.x + 2.0f;
    return button * static_cast<float>(row.choiceLabels.size()) <= ImGui::CalcItemWidth();
}

bool editChoice(const Parameter& row, Look& look) {
    const int before = std::get<int>(valueOf(look, row));
    ImGui::BeginGroup();
    const int after =
        fitsOnButtons(row) ? chooseByButton(row, before) : chooseFromList(row, before);
    ImGui::EndGroup();
    if (after == before) return false;
    setValue(look, row, after);
    return true;
}

bool editToggle(const Parameter& row, Look& look) {
    bool value = std::get<bool>(valueOf(look, row));
    if (!ImGui::Checkbox("##value", &value)) return false;
    setValue(look, row, value);
    return true;
}

bool editColour(const Parameter& row, Look& look) {
    auto colour = std::get<glm::vec3>(valueOf(look, row));
    const ImGuiColorEditFlags flags = ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs |
                                      ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoOptions;
    if (!ImGui::ColorEdit3("##value", &colour.x, flags)) return false;
    setValue(look, row, glm::clamp(colour, 0.0f, 1.0f));
    return true;
}

bool edit(const Parameter& row, Look& look) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return editToggle(row, look);
        case ParameterKind::integer:
            return editInteger(row, look);
        case ParameterKind::choice:
            return editChoice(row, look);
        case ParameterKind::colour:
            return editColour(row, look);
        case ParameterKind::number:
            break;
    }
    return editNumber(row, look);
}

}  // namespace

bool parameterEditor(const Parameter& row, Look& look) {
    ImGui::PushID(row.id.c_str());
    bool changed = edit(row, look);
    changed |= resetMenu(row, look);
    tooltip(row);
    ImGui::PopID();
    return changed;
}

bool parameterWidget(const Parameter& row, Look& look) {
    const float line = ImGui::GetContentRegionAvail().x;
    const float start = ImGui::GetCursorPosX();
    const bool standard = valueOf(look, row) == defaultOf(row);
    ImGui::PushID(row.id.c_str());
    ImGui::PushID("label");
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text,
                          ImGui::GetColorU32(ImGuiCol_Text, standard ? 0.75f : 1.0f));
    ImGui::TextUnformatted(row.label.c_str());
    ImGui::PopStyleColor();
    bool changed = false;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        changed = reset(row, look);
    }
    changed |= resetMenu(row, look);
    tooltip(row);
    ImGui::PopID();
    ImGui::PopID();
    ImGui::SameLine(start + line * kLabelShare);
    ImGui::SetNextItemWidth(-1.0f);
    changed |= parameterEditor(row, look);
    return changed;
}

}  // namespace neph::ui
