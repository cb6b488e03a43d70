// preset_details.cpp: what a preset would change, part by part, before it is applied.
#include "app/ui/presets/preset_details.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/ui/presets/preset_card.h"
#include "app/ui/presets/preset_commands.h"
#include "app/ui/widgets/dialogue.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"

namespace neph::ui {
namespace {

constexpr float kWidthEms = 34.0f, kImageEms = 14.0f;
constexpr int kMostLines = 16;

void drawHead(const PresetCard& card) {
    const float em = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const glm::vec2 lower{at.x, at.y};
    const glm::vec2 size{kImageEms * em, kImageEms * em / kThumbnailAspect};
    drawPresetImage(card, lower, lower + size);
    ImGui::Dummy({size.x, size.y});
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(kWidthEms * em);
    ImGui::TextUnformatted(card.entry.name.c_str());
    if (!card.preset.title.empty()) ImGui::TextUnformatted(card.preset.title.c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    if (!card.preset.description.empty()) ImGui::TextUnformatted(card.preset.description.c_str());
    ImGui::TextUnformatted(card.entry.bundled ? "Bundled" : card.entry.file.c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
}

/// A button a part; returns the part under the mouse, or all.
PresetParts drawButtons(Session& session, PresetBrowser& presets, const PresetCard& card,
                        const std::vector<PresetDifference>& rows) {
    PresetParts under = kPresetAll;
    const auto button = [&](std::string_view label, std::string_view id, std::string_view help,
                            PresetParts parts) {
        const auto count =
            std::ranges::count_if(rows, [&](const auto& row) { return (row.part & parts) != 0; });
        ImGui::BeginDisabled(count == 0);
        if (ImGui::Button(fmt::format("{} ({})###{}", label, count, id).c_str())) {
            applyPreset(session, presets, card.entry.name, parts);
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndDisabled();
        place(fmt::format("preset_details.{}", id));
        if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
            under = parts;
        }
        tooltip(std::string(help));
        ImGui::SameLine();
    };
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Apply");
    ImGui::SameLine();
    button("All", "all", "Everything listed", kPresetAll);
    for (const PresetPart& part : kPresetParts) button(part.label, part.id, part.help, part.bit);
    ImGui::NewLine();
    return under;
}

void drawRow(const PresetDifference& row, bool lit) {
    const ImVec4 colour = ImGui::GetStyleColorVec4(lit ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TableNextRow();
    for (const std::string& text : {row.group + ": " + row.label, row.before, row.after}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(text.c_str());
    }
    ImGui::PopStyleColor();
}

/// Those of `lit` parts stand out.
void drawRows(const std::vector<PresetDifference>& rows, PresetParts lit) {
    const int lines = std::min(kMostLines, static_cast<int>(rows.size()) + 1);
    const float height = static_cast<float>(lines) *
                             (ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y) +
                         2.0f;
    const ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                  ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("##rows", 3, flags, {0.0f, height})) return;
    ImGui::TableSetupColumn("Parameter", 0, 2.0f);
    ImGui::TableSetupColumn("Now", 0, 1.0f);
    ImGui::TableSetupColumn("Preset", 0, 1.0f);
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableHeadersRow();
    for (const PresetDifference& row : rows) drawRow(row, (row.part & lit) != 0);
    ImGui::EndTable();
}

}  // namespace

void drawPresetDetails(Session& session, PresetBrowser& presets) {
    if (std::exchange(presets.openDetails, false)) ImGui::OpenPopup("##preset details");
    const float width = dialogueWidth(kWidthEms + 2.0f);
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, dialogueRoom().y});
    if (!ImGui::BeginPopup("##preset details")) return;
    const auto card = std::ranges::find(presets.cards, presets.subject,
                                        [](const PresetCard& c) { return c.entry.name; });
    if (card == presets.cards.end()) {
        ImGui::CloseCurrentPopup();
    } else if (!card->fault.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, errorColour());
        ImGui::TextWrapped("%s", card->fault.c_str());
        ImGui::PopStyleColor();
    } else {
        drawHead(*card);
        ImGui::Spacing();
        const std::vector<PresetDifference> rows = differencesTo(session, card->preset);
        const PresetParts lit = drawButtons(session, presets, *card, rows);
        if (rows.empty()) {
            ImGui::TextDisabled("The current look and camera are those of the preset");
        } else {
            drawRows(rows, lit);
        }
    }
    ImGui::EndPopup();
}

}  // namespace neph::ui
