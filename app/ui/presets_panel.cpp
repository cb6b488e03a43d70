// presets_panel.cpp: presets to load, and a name to save under.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/ui/panels.h"
#include "core/error.h"

namespace neph::ui {
namespace {

constexpr int kVisibleRows = 11;

std::string tooltipOf(const PresetEntry& entry) {
    try {
        const Preset preset = loadPreset(entry.file).preset;
        std::string text = preset.title;
        if (!preset.description.empty()) text += (text.empty() ? "" : "\n") + preset.description;
        return text.empty() ? entry.file.string() : text;
    } catch (const Error& error) {
        return error.message();
    }
}

void list(Ui& ui) {
    ui.presets.entries = listPresets();
    ui.presets.titles.clear();
    for (const PresetEntry& entry : ui.presets.entries)
        ui.presets.titles.push_back(tooltipOf(entry));
    ui.presets.listed = true;
}

void drawEntry(Ui& ui, std::size_t i) {
    const PresetEntry& entry = ui.presets.entries[i];
    const std::string label = entry.name + (entry.bundled ? "" : "  (yours)");
    // The chosen one must be told from the one under the mouse.
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Selectable(label.c_str(), entry.name == ui.session().presetName)) {
        ui.session().loadPreset(entry.name);
    }
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26.0f);
        ImGui::TextUnformatted(ui.presets.titles[i].c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

void drawSave(Ui& ui) {
    const float button = ImGui::CalcTextSize("Save").x + 3.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
    const bool entered =
        ImGui::InputTextWithHint("##name", "Save look and camera as", &ui.presets.name,
                                 ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::SameLine();
    ImGui::BeginDisabled(ui.presets.name.empty());
    if ((ImGui::Button("Save") || entered) && !ui.presets.name.empty()) {
        ui.session().savePreset(ui.presets.name);
        ui.presets.listed = false;
    }
    ImGui::EndDisabled();
}

}  // namespace

void drawPresets(Ui& ui) {
    if (!ImGui::CollapsingHeader("Presets", ImGuiTreeNodeFlags_DefaultOpen)) {
        ui.presets.listed = false;  // looked up anew when it is unfolded
        return;
    }
    const bool listedNow = !ui.presets.listed;
    if (listedNow) list(ui);
    const int rows = std::min(kVisibleRows, static_cast<int>(ui.presets.entries.size()));
    const float height = static_cast<float>(rows) * ImGui::GetTextLineHeightWithSpacing();
    if (rows > 0 && ImGui::BeginChild("##presets", {0.0f, height})) {
        for (std::size_t i = 0; i < ui.presets.entries.size(); ++i) {
            drawEntry(ui, i);
            if (listedNow && ui.presets.entries[i].name == ui.session().presetName)
                ImGui::SetScrollHereY();
        }
    }
    if (rows > 0) ImGui::EndChild();
    drawSave(ui);
}

}  // namespace neph::ui
