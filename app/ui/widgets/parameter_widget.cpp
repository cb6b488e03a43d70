// parameter_widget.cpp: label, mark, tooltip and menu around the editor of a row.
#include "app/ui/widgets/parameter_widget.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/widgets/colour_editor.h"
#include "app/ui/widgets/format.h"
#include "app/ui/widgets/number_slider.h"
#include "app/ui/widgets/places.h"
#include "core/base/error.h"
#include "core/look/choice_help.h"

namespace neph::ui {
namespace {

constexpr float kLabelShare = 0.42f;  // of the line
constexpr float kTooltipEms = 26.0f;  // width of a tooltip in letters
constexpr double kTooltipDelayS = 0.35;
constexpr std::size_t kMaxButtons = 3;  // choices shown side by side; more make a list
constexpr float kMarkEms = 0.14f, kMarkGapEms = 0.28f;

/// Whether the mouse has rested on the last item for a while, and does not drag.
bool rested(const Parameter& row) {
    static const Parameter* last = nullptr;
    static double since = 0.0;
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return false;
    const bool moved = ImGui::GetIO().MouseDelta.x != 0.0f || ImGui::GetIO().MouseDelta.y != 0.0f;
    if (last != &row || moved || ImGui::IsAnyItemActive()) {
        last = &row;
        since = ImGui::GetTime();
    }
    return ImGui::GetTime() - since >= kTooltipDelayS;
}

void listChoices(const Parameter& row, const Look& look) {
    const int chosen = std::get<int>(valueOf(look, row));
    ImGui::Spacing();
    for (int i = 0; i < static_cast<int>(row.choices.size()); ++i) {
        const std::string_view help = choiceHelp(row, i);
        if (help.empty()) continue;
        const std::string text =
            fmt::format("{}: {}", row.choiceLabels[static_cast<std::size_t>(i)], help);
        const ImGuiCol colour = i == chosen ? ImGuiCol_CheckMark : ImGuiCol_Text;
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(colour));
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopStyleColor();
    }
}

void tooltip(const Parameter& row, const Look& look, const Look& preset) {
    if (!rested(row)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * kTooltipEms);
    ImGui::Text("%s: %s", row.group.c_str(), row.label.c_str());
    ImGui::Separator();
    ImGui::TextUnformatted(row.help.c_str());
    if (row.kind == ParameterKind::choice) listChoices(row, look);
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(factsOf(row, preset).c_str());
    ImGui::TextUnformatted(row.id.c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool assign(const Parameter& row, Look& look, const ParameterValue& value) {
    if (valueOf(look, row) == value) return false;
    setValue(look, row, value);
    return true;
}

bool resetItem(const char* label, const Parameter& row, Look& look, const ParameterValue& value) {
    const bool other = valueOf(look, row) != value;
    return ImGui::MenuItem(label, screenText(row, value).c_str(), false, other) &&
           assign(row, look, value);
}

bool pasteItem(const Parameter& row, Look& look) {
    const char* held = ImGui::GetClipboardText();
    bool changed = false;
    try {
        const ParameterValue value = pastedValue(row, held == nullptr ? "" : held);
        if (ImGui::MenuItem("Paste value", screenText(row, value).c_str())) {
            changed = assign(row, look, value);
        }
    } catch (const Error& error) {
        ImGui::MenuItem("Paste value", nullptr, false, false);
        if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
            ImGui::SetTooltip("%s", error.message().c_str());
        }
    }
    return changed;
}

/// Menu on right click on the last item.
bool menu(const Parameter& row, Look& look, const Look& preset) {
    if (!ImGui::BeginPopupContextItem("##menu")) return false;
    bool changed = resetItem("Reset to the preset", row, look, valueOf(preset, row));
    place("menu.preset");
    changed |= resetItem("Reset to the default", row, look, defaultOf(row));
    place("menu.default");
    ImGui::Separator();
    if (ImGui::MenuItem("Copy id", row.id.c_str())) ImGui::SetClipboardText(row.id.c_str());
    const std::string pair = row.id + "=" + formatValue(row, valueOf(look, row));
    if (ImGui::MenuItem("Copy id=value")) ImGui::SetClipboardText(pair.c_str());
    changed |= pasteItem(row, look);
    place("menu.paste");
    ImGui::EndPopup();
    return changed;
}

bool editNumber(const Parameter& row, Look& look) {
    const ParameterValue before = valueOf(look, row);
    const bool whole = row.kind == ParameterKind::integer;
    const double si = whole ? static_cast<double>(std::get<int>(before))
                            : static_cast<double>(std::get<float>(before));
    double shown = si * row.displayScale;
    const NumberRange range{row.range.lo * row.displayScale, row.range.hi * row.displayScale,
                            row.range.log, whole};
    if (!numberSlider("##value", shown, range, screenText(row, before), unitSuffix(row))) {
        return false;
    }
    const double wanted = std::clamp(shown / row.displayScale, row.range.lo, row.range.hi);
    if (whole) return assign(row, look, static_cast<int>(wanted));
    return assign(row, look, static_cast<float>(wanted));
}

void choiceTooltip(const Parameter& row, int choice) {
    const std::string help(choiceHelp(row, choice));
    if (!help.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help.c_str());
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
    // Where the words need the room there is no arrow.
    const float words =
        ImGui::CalcTextSize(current.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    const bool tight = words + ImGui::GetFrameHeight() > ImGui::CalcItemWidth();
    const auto flags = tight ? ImGuiComboFlags_NoArrowButton : ImGuiComboFlags_None;
    if (!ImGui::BeginCombo("##value", current.c_str(), flags)) return chosen;
    for (int i = 0; i < static_cast<int>(row.choiceLabels.size()); ++i) {
        const std::string label(row.choiceLabels[static_cast<std::size_t>(i)]);
        if (ImGui::Selectable(label.c_str(), i == chosen)) chosen = i;
        choiceTooltip(row, i);
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
    return assign(row, look, after);
}

bool editToggle(const Parameter& row, Look& look) {
    bool value = std::get<bool>(valueOf(look, row));
    return ImGui::Checkbox("##value", &value) && assign(row, look, value);
}

bool editColour(const Parameter& row, Look& look) {
    auto colour = std::get<glm::vec3>(valueOf(look, row));
    return colourEditor("##value", colour) && assign(row, look, colour);
}

bool edit(const Parameter& row, Look& look) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return editToggle(row, look);
        case ParameterKind::choice:
            return editChoice(row, look);
        case ParameterKind::colour:
            return editColour(row, look);
        case ParameterKind::integer:
        case ParameterKind::number:
            break;
    }
    return editNumber(row, look);
}

}  // namespace

bool parameterExtras(const Parameter& row, Look& look, const Look& preset) {
    ImGui::PushID(row.id.c_str());
    const bool changed = menu(row, look, preset);
    tooltip(row, look, preset);
    ImGui::PopID();
    return changed;
}

bool parameterEditor(const Parameter& row, Look& look, const Look& preset) {
    ImGui::PushID(row.id.c_str());
    const bool changed = edit(row, look);
    ImGui::PopID();
    place(row.id);
    return parameterExtras(row, look, preset) || changed;
}

void changedMark(const Parameter& row, const Look& look, const Look& preset) {
    if (valueOf(look, row) == valueOf(preset, row)) return;
    const float em = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled(
        {at.x - kMarkGapEms * em, at.y + ImGui::GetFrameHeight() / 2.0f}, kMarkEms * em,
        ImGui::GetColorU32(ImGuiCol_CheckMark));
}

bool parameterWidget(const Parameter& row, Look& look, const Look& preset) {
    const float line = ImGui::GetContentRegionAvail().x;
    const float start = ImGui::GetCursorPosX();
    ImGui::PushID(row.id.c_str());
    ImGui::PushID("label");
    changedMark(row, look, preset);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row.label.c_str());
    place(row.id + ":label");
    bool changed = false;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        changed = assign(row, look, valueOf(preset, row));
    }
    changed |= parameterExtras(row, look, preset);
    ImGui::PopID();
    ImGui::PopID();
    ImGui::SameLine(start + line * kLabelShare);
    ImGui::SetNextItemWidth(-1.0f);
    changed |= parameterEditor(row, look, preset);
    return changed;
}

}  // namespace neph::ui
