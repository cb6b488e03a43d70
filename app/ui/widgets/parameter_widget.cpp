// parameter_widget.cpp: label, mark, tooltip and menu around the editor of a row.
#include "app/ui/widgets/parameter_widget.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/widgets/colour_editor.h"
#include "app/ui/widgets/format.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/number_slider.h"
#include "app/ui/widgets/places.h"
#include "core/base/error.h"

namespace neph::ui {
namespace {

constexpr float kLabelShare = 0.42f;  // of the line
constexpr double kTooltipDelayS = 0.35;
constexpr std::size_t kMaxButtons = 3;  // choices shown side by side; more make a list
constexpr float kMarkEms = 0.14f, kMarkGapEms = 0.28f;

/// Whether the mouse has rested on the last item for a while, and does not drag.
bool rested(const Parameter& row) {
    static const Parameter* last = nullptr;
    static double since = 0.0;
    if (!wantsTooltip()) return false;
    const bool moved = ImGui::GetIO().MouseDelta.x != 0.0f || ImGui::GetIO().MouseDelta.y != 0.0f;
    if (last != &row || moved || ImGui::IsAnyItemActive()) {
        last = &row;
        since = ImGui::GetTime();
    }
    return ImGui::GetTime() - since >= kTooltipDelayS;
}

void listChoices(const Parameter& row, const ParameterSet& values) {
    const auto chosen = static_cast<std::size_t>(std::get<int>(valueOf(values, row)));
    ImGui::Spacing();
    for (const Choice& choice : row.choices) {
        const std::string text = fmt::format("{}: {}", choice.label, choice.help);
        const bool lit = &choice == &row.choices[chosen];
        const ImGuiCol colour = lit ? ImGuiCol_CheckMark : ImGuiCol_Text;
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(colour));
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopStyleColor();
    }
}

void explain(const Parameter& row, const ParameterSet& values, const Look& preset) {
    if (!rested(row) || !beginTooltip()) return;
    ImGui::Text("%s: %s", row.group.c_str(), row.label.c_str());
    ImGui::Separator();
    ImGui::TextUnformatted(row.help.c_str());
    if (row.kind == ParameterKind::choice) listChoices(row, values);
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(factsOf(row, preset).c_str());
    ImGui::TextUnformatted(row.id.c_str());
    ImGui::PopStyleColor();
    endTooltip();
}

bool assign(const Parameter& row, ParameterSet& values, const ParameterValue& value) {
    if (valueOf(values, row) == value) return false;
    setValue(values, row, value);
    return true;
}

bool resetItem(const char* label, const Parameter& row, ParameterSet& values,
               const ParameterValue& value) {
    const bool other = valueOf(values, row) != value;
    return ImGui::MenuItem(label, screenText(row, value).c_str(), false, other) &&
           assign(row, values, value);
}

bool pasteItem(const Parameter& row, ParameterSet& values) {
    const char* held = ImGui::GetClipboardText();
    bool changed = false;
    try {
        const ParameterValue value = pastedValue(row, held == nullptr ? "" : held);
        if (ImGui::MenuItem("Paste value", screenText(row, value).c_str())) {
            changed = assign(row, values, value);
        }
    } catch (const Error& error) {
        ImGui::MenuItem("Paste value", nullptr, false, false);
        tooltip(error.message());
    }
    return changed;
}

/// Menu on right click on the last item.
bool menu(const Parameter& row, ParameterSet& values, const Look& preset) {
    if (!ImGui::BeginPopupContextItem("##menu")) return false;
    bool changed = false;
    if (row.part != ParameterPart::sampling) {
        changed |= resetItem("Reset to the preset", row, values, valueOf(preset, row));
        place("menu.preset");
    }
    changed |= resetItem("Reset to the default", row, values, defaultOf(row));
    place("menu.default");
    ImGui::Separator();
    if (ImGui::MenuItem("Copy id", row.id.c_str())) ImGui::SetClipboardText(row.id.c_str());
    const std::string pair = row.id + "=" + formatValue(row, valueOf(values, row));
    if (ImGui::MenuItem("Copy id=value")) ImGui::SetClipboardText(pair.c_str());
    changed |= pasteItem(row, values);
    place("menu.paste");
    ImGui::EndPopup();
    return changed;
}

bool editNumber(const Parameter& row, ParameterSet& values) {
    const ParameterValue before = valueOf(values, row);
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
    if (whole) return assign(row, values, static_cast<int>(wanted));
    return assign(row, values, static_cast<float>(wanted));
}

void choiceTooltip(const Choice& choice) {
    tooltip(std::string(choice.help));
}

/// Buttons side by side, the chosen one lit.
int chooseByButton(const Parameter& row, int chosen) {
    const float spacing = ImGui::GetStyle().ItemInnerSpacing.x / 2.0f;
    const auto count = static_cast<float>(row.choices.size());
    const float width = (ImGui::CalcItemWidth() - spacing * (count - 1.0f)) / count;
    for (int i = 0; i < static_cast<int>(row.choices.size()); ++i) {
        if (i > 0) ImGui::SameLine(0.0f, spacing);
        const bool lit = i == chosen;
        if (lit) {
            const ImVec4 accent = ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive);
            ImGui::PushStyleColor(ImGuiCol_Button, accent);
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, accent);
        }
        const std::string label(row.choices[static_cast<std::size_t>(i)].label);
        if (ImGui::Button(label.c_str(), {width, 0.0f})) chosen = i;
        if (lit) ImGui::PopStyleColor(2);
    }
    return chosen;
}

int chooseFromList(const Parameter& row, int chosen) {
    const std::string current(row.choices[static_cast<std::size_t>(chosen)].label);
    // Where the words need the room there is no arrow.
    const float words =
        ImGui::CalcTextSize(current.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    const bool tight = words + ImGui::GetFrameHeight() > ImGui::CalcItemWidth();
    const auto flags = tight ? ImGuiComboFlags_NoArrowButton : ImGuiComboFlags_None;
    if (!ImGui::BeginCombo("##value", current.c_str(), flags)) return chosen;
    for (int i = 0; i < static_cast<int>(row.choices.size()); ++i) {
        const std::string label(row.choices[static_cast<std::size_t>(i)].label);
        if (ImGui::Selectable(label.c_str(), i == chosen)) chosen = i;
        choiceTooltip(row.choices[static_cast<std::size_t>(i)]);
    }
    ImGui::EndCombo();
    return chosen;
}

/// Whether the labels of a choice fit on buttons in the width of the next item.
bool fitsOnButtons(const Parameter& row) {
    if (row.choices.size() > kMaxButtons) return false;
    float widest = 0.0f;
    for (const auto& [id, label, help] : row.choices) {
        widest = std::max(widest, ImGui::CalcTextSize(label.data(), label.data() + label.size()).x);
    }
    const float button = widest + 2.0f * ImGui::GetStyle().FramePadding.x + 2.0f;
    return button * static_cast<float>(row.choices.size()) <= ImGui::CalcItemWidth();
}

bool editChoice(const Parameter& row, ParameterSet& values) {
    const int before = std::get<int>(valueOf(values, row));
    ImGui::BeginGroup();
    const int after =
        fitsOnButtons(row) ? chooseByButton(row, before) : chooseFromList(row, before);
    ImGui::EndGroup();
    return assign(row, values, after);
}

bool editToggle(const Parameter& row, ParameterSet& values) {
    bool value = std::get<bool>(valueOf(values, row));
    return ImGui::Checkbox("##value", &value) && assign(row, values, value);
}

bool editColour(const Parameter& row, ParameterSet& values) {
    auto colour = std::get<glm::vec3>(valueOf(values, row));
    return colourEditor("##value", colour) && assign(row, values, colour);
}

bool edit(const Parameter& row, ParameterSet& values) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return editToggle(row, values);
        case ParameterKind::choice:
            return editChoice(row, values);
        case ParameterKind::colour:
            return editColour(row, values);
        case ParameterKind::integer:
        case ParameterKind::number:
            break;
    }
    return editNumber(row, values);
}

}  // namespace

bool parameterExtras(const Parameter& row, ParameterSet& values, const Look& preset) {
    ImGui::PushID(row.id.c_str());
    const bool changed = menu(row, values, preset);
    explain(row, values, preset);
    ImGui::PopID();
    return changed;
}

bool parameterEditor(const Parameter& row, ParameterSet& values, const Look& preset) {
    ImGui::PushID(row.id.c_str());
    const bool changed = edit(row, values);
    ImGui::PopID();
    place(row.id);
    return parameterExtras(row, values, preset) || changed;
}

void changedMark(const Parameter& row, const ParameterSet& values, const Look& preset) {
    if (valueOf(values, row) == startingValue(row, preset)) return;
    const float em = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled(
        {at.x - kMarkGapEms * em, at.y + ImGui::GetFrameHeight() / 2.0f}, kMarkEms * em,
        ImGui::GetColorU32(ImGuiCol_CheckMark));
}

bool parameterLabel(const Parameter& row, const std::string& text, ParameterSet& values,
                    const Look& preset) {
    ImGui::PushID(row.id.c_str());
    ImGui::PushID("label");
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    place(row.id + ":label");
    bool changed = false;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        changed = assign(row, values, startingValue(row, preset));
    }
    changed |= parameterExtras(row, values, preset);
    ImGui::PopID();
    ImGui::PopID();
    return changed;
}

bool parameterWidget(const Parameter& row, ParameterSet& values, const Look& preset) {
    const float line = ImGui::GetContentRegionAvail().x;
    const float start = ImGui::GetCursorPosX();
    changedMark(row, values, preset);
    bool changed = parameterLabel(row, row.label, values, preset);
    ImGui::SameLine(start + line * kLabelShare);
    ImGui::SetNextItemWidth(-1.0f);
    changed |= parameterEditor(row, values, preset);
    return changed;
}

}  // namespace neph::ui
