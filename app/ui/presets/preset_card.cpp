// preset_card.cpp: drawn by hand on one invisible button.
#include "app/ui/presets/preset_card.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/presets/preset_commands.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"
#include "core/base/error.h"
#include "core/preset/preset_files.h"

namespace neph::ui {
namespace {

constexpr float kRounding = 3.0f;
constexpr double kTooltipDelayS = 0.5;
constexpr float kTooltipEms = 30.0f;
constexpr std::size_t kTooltipRows = 12;

/// Of the place that opens the details: a finger's breadth more than its dots.
float dotsWidth() {
    return ImGui::CalcTextSize("...").x + 0.6f * ImGui::GetFontSize();
}

/// Whether the mouse has rested on the last item for a while.
bool restsOn(PresetBrowser& presets, const std::string& name) {
    if (!wantsTooltip()) {
        if (presets.rested == name) presets.rested.clear();
        return false;
    }
    if (presets.rested != name || ImGui::IsAnyMouseDown()) {
        presets.rested = name;
        presets.restedS = ImGui::GetTime();
    }
    return ImGui::GetTime() - presets.restedS > kTooltipDelayS;
}

/// Beside the column where there is room, so that the other cards stay in sight.
void drawTooltip(const Session& session, const PresetCard& card) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float left = ImGui::GetWindowPos().x - ImGui::GetFontSize();
    if (left > kTooltipEms * ImGui::GetFontSize()) {
        const bool low = ImGui::GetItemRectMin().y > display.y / 2.0f;
        const float y = low ? ImGui::GetItemRectMax().y : ImGui::GetItemRectMin().y;
        ImGui::SetNextWindowPos({left, y}, 0, {1.0f, low ? 1.0f : 0.0f});
    }
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * kTooltipEms);
    ImGui::TextUnformatted(describePresetCard(session, card, kTooltipRows).c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void drawApplyItems(Session& session, PresetBrowser& presets, const PresetCard& card) {
    const std::vector<PresetDifference> rows = differencesTo(session, card.preset);
    if (ImGui::MenuItem("Apply all")) applyPreset(session, presets, card.entry.name);
    for (const PresetPart& part : kPresetParts) {
        const auto count =
            std::ranges::count(rows, part.bit, [](const auto& row) { return row.part; });
        const std::string label = fmt::format("Apply {} only ({})", part.id, count);
        if (ImGui::MenuItem(label.c_str(), nullptr, false, count > 0)) {
            applyPreset(session, presets, card.entry.name, part.bit);
        }
    }
    if (ImGui::MenuItem("Details...")) {
        presets.subject = card.entry.name;
        presets.openDetails = true;
    }
}

void drawFileItems(Session& session, PresetBrowser& presets, const PresetCard& card) {
    const std::string& name = card.entry.name;
    const bool own = !card.entry.bundled;
    if (ImGui::MenuItem("Duplicate")) {
        changePresets(session, presets, [&] { return "Duplicated as " + duplicatePreset(name); });
    }
    place("preset_menu.duplicate");
    if (ImGui::MenuItem("Rename...", nullptr, false, own)) {
        openPresetDialog(session, presets, PresetDialog::rename, name);
    }
    if (ImGui::MenuItem("Title and description...", nullptr, false, own)) {
        openPresetDialog(session, presets, PresetDialog::describe, name);
    }
    if (ImGui::MenuItem("Delete to trash", nullptr, false, own)) {
        changePresets(session, presets,
                      [&] { return "In the trash: " + deletePreset(name).string(); });
    }
    place("preset_menu.delete");
    if (!own) ImGui::TextDisabled("Bundled: duplicate it to change it");
}

void drawMenu(Session& session, PresetBrowser& presets, const PresetCard& card) {
    ImGui::TextDisabled("%s", card.entry.name.c_str());
    ImGui::Separator();
    if (card.fault.empty()) drawApplyItems(session, presets, card);
    ImGui::Separator();
    drawFileItems(session, presets, card);
    ImGui::Separator();
    if (ImGui::MenuItem("Copy as JSON", nullptr, false, card.fault.empty())) {
        copyPreset(session, card.preset);
    }
    if (ImGui::MenuItem("Copy the file's path")) {
        ImGui::SetClipboardText(card.entry.file.c_str());
        session.say(Message::Kind::note, "Copied: " + card.entry.file.string());
    }
}

/// Image, outline and name.
void drawFace(const Session& session, const PresetCard& card, glm::vec2 at, float width,
              bool hovered) {
    const glm::vec2 corner = at + glm::vec2(width, width / kThumbnailAspect);
    drawPresetImage(card, at, corner);
    const bool loaded = card.entry.name == session.presetName;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (loaded || hovered) {
        const ImU32 colour = ImGui::GetColorU32(loaded ? ImGuiCol_CheckMark : ImGuiCol_Text);
        list.AddRect({at.x, at.y}, {corner.x, corner.y}, colour, kRounding, 0,
                     loaded ? 2.0f : 1.0f);
    }
    const bool changed = loaded && presetChanged(session);
    const std::string name = (changed ? "* " : "") + card.entry.name;
    const float room = width - dotsWidth();
    const bool fits = ImGui::CalcTextSize(name.c_str()).x <= room;
    const ImVec4 plain = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    list.AddText({at.x, corner.y + 2.0f},
                 ImGui::GetColorU32(card.fault.empty() ? plain : errorColour()),
                 (fits ? name : shortened(name, room)).c_str());
}

}  // namespace

float presetCardHeight(float width) {
    return width / kThumbnailAspect + ImGui::GetTextLineHeight() + 4.0f;
}

void drawPresetImage(const PresetCard& card, glm::vec2 lower, glm::vec2 upper) {
    if (card.texture == 0) {
        if (card.placeholder) drawPlaceholder(*card.placeholder, lower, upper);
        return;
    }
    ImGui::GetWindowDrawList()->AddImageRounded(
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(card.texture)),
        {lower.x, lower.y}, {upper.x, upper.y}, {0.0f, 0.0f}, {1.0f, 1.0f}, IM_COL32_WHITE,
        kRounding);
}

std::string describePresetCard(const Session& session, const PresetCard& card, std::size_t most) {
    if (!card.fault.empty()) return card.fault;
    std::string text = card.preset.title.empty() ? card.entry.name : card.preset.title;
    wantGlyphs(text);
    if (!card.preset.description.empty()) text += "\n" + card.preset.description;
    const std::vector<PresetDifference> rows = differencesTo(session, card.preset);
    if (rows.empty()) return text + "\n\nJust as it is now";
    return text + "\n\nWould change:\n" + linesOf(rows, most);
}

void drawPresetCard(Session& session, PresetBrowser& presets, const PresetCard& card, float width) {
    ImGui::PushID(card.entry.name.c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float dots = dotsWidth();
    if (ImGui::InvisibleButton("##card", {width, presetCardHeight(width)})) {
        applyPreset(session, presets, card.entry.name);
    }
    place("preset:" + card.entry.name);
    ImGui::SetItemAllowOverlap();
    const bool hovered = ImGui::IsItemHovered();
    if (restsOn(presets, card.entry.name)) drawTooltip(session, card);
    if (ImGui::BeginPopupContextItem("##menu")) {
        drawMenu(session, presets, card);
        ImGui::EndPopup();
    }
    drawFace(session, card, {at.x, at.y}, width, hovered);
    ImGui::SetCursorScreenPos({at.x + width - dots, at.y + width / kThumbnailAspect + 2.0f});
    if (ImGui::InvisibleButton("##details", {dots, ImGui::GetTextLineHeight()})) {
        presets.subject = card.entry.name;
        presets.openDetails = true;
    }
    place("preset:" + card.entry.name + ".details");
    const bool hot = ImGui::IsItemHovered();
    tooltip("What it would change, and parts of it");
    ImGui::GetWindowDrawList()->AddText(
        {at.x + width - ImGui::CalcTextSize("...").x, at.y + width / kThumbnailAspect + 2.0f},
        ImGui::GetColorU32(hot ? ImGuiCol_Text : ImGuiCol_TextDisabled), "...");
    ImGui::PopID();
}

}  // namespace neph::ui
