// preset_browser.cpp: the browser of presets: which one is loaded and what has changed since, a
// search, a grid of cards, and what the last one applied has changed.
#include "app/ui/presets/preset_browser.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/ui/presets/preset_card.h"
#include "app/ui/presets/preset_commands.h"
#include "app/ui/presets/preset_details.h"
#include "app/ui/presets/preset_thumbnails.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/words.h"
#include "core/base/error.h"
#include "core/preset/preset_files.h"

namespace neph::ui {
namespace {

constexpr float kCardEms = 7.0f;     // least width; two stand in a column of usual width
constexpr float kGridEms = 19.0f;    // least height: more is scrolled to
constexpr float kGridShare = 0.35f;  // of the window's height, where that is more
constexpr double kLookS = 1.0;       // between looks whether files have changed
constexpr std::size_t kTooltipRows = 12, kChangeRows = 10;

void list(const Services& services, PresetBrowser& presets) {
    std::vector<PresetCard> cards;
    for (PresetEntry& entry : listPresets()) {
        PresetCard& card = cards.emplace_back();
        card.entry = std::move(entry);
        try {
            card.preset = loadPreset(card.entry.file).preset;
        } catch (const Error& error) {
            card.fault = error.message();
        }
    }
    keepThumbnails(services, presets, cards);
    if (presets.cards.empty()) presets.revealed = false;  // the first list
    presets.cards = std::move(cards);
    presets.listed = true;
    presets.triedThumbnails = false;
}

/// Lists them again when files have come, gone or changed, by whomever.
void keepListed(const Services& services, PresetBrowser& presets) {
    const double now = ImGui::GetTime();
    if (presets.listed && now - presets.lookedS < kLookS) return;
    presets.lookedS = now;
    const std::filesystem::file_time_type stamp = presetsStamp();
    if (presets.listed && stamp == presets.stamp) return;
    presets.stamp = stamp;
    list(services, presets);
}

/// Every word that is searched for stands in the name, the title or the description.
bool isFound(const PresetCard& card, const std::string& search) {
    return holdsWords(card.entry.name + "\n" + card.preset.title + "\n" + card.preset.description,
                      search);
}

/// A button for an action, on the line of those before while there is room.
void actionButton(const ActionLookup& actions, const char* label, std::string_view id,
                  bool first = false) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcTextSize(label).x + 2.0f * style.FramePadding.x;
    if (!first) {
        const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
        if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right) ImGui::SameLine();
    }
    if (ImGui::Button(label)) actions.run(id);
    place("panel:" + std::string(id));
    tooltip(actions.face(id).tooltip);
}

/// The loaded preset, and what is otherwise now.
void drawLoaded(const Session& session) {
    const std::string name =
        session.presetName.empty() ? "no preset" : presetLabel(session.presetName);
    if (!presetChanged(session)) {
        ImGui::TextUnformatted(name.c_str());
        return;
    }
    const auto rows = differences(session.presetLook, session.document.look);
    ImGui::TextUnformatted(("* " + name).c_str());
    ImGui::SameLine();
    ImGui::TextDisabled(
        "%s", rows.size() == 1 ? "1 change" : fmt::format("{} changes", rows.size()).c_str());
    place("presets.changes");
    tooltip("Since it was loaded or saved:\n" + linesOf(rows, kTooltipRows));
}

void drawButtons(const ActionLookup& actions) {
    actionButton(actions, "Save", "preset.save", true);
    actionButton(actions, "Save as", "preset.save_as");
    actionButton(actions, "Copy", "preset.copy");
    actionButton(actions, "Paste", "preset.paste");
    actionButton(actions, "Open", "preset.open");
}

void drawSearch(PresetBrowser& presets) {
    const float clear = ImGui::GetFrameHeight();
    ImGui::SetNextItemWidth(presets.search.empty() ? -1.0f
                                                   : -clear - ImGui::GetStyle().ItemSpacing.x);
    ImGui::InputTextWithHint("##search", "Search", &presets.search);
    place("presets.search");
    if (presets.search.empty()) return;
    ImGui::SameLine();
    if (ImGui::Button("x", {clear, 0.0f})) presets.search.clear();
}

/// The cards of one section side by side, below its heading.
void drawSection(Session& session, PresetBrowser& presets, const char* heading,
                 const std::vector<const PresetCard*>& cards) {
    if (cards.empty()) return;
    ImGui::TextDisabled("%s", heading);
    const float space = ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns =
        std::max(1, static_cast<int>((room + space) / (kCardEms * ImGui::GetFontSize() + space)));
    const auto count = static_cast<float>(columns);
    const float width = std::floor((room - space * (count - 1.0f)) / count);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float tall = presetCardHeight(width) + ImGui::GetStyle().ItemSpacing.y;
    for (std::size_t i = 0; i < cards.size(); ++i) {
        const auto column = static_cast<float>(i % static_cast<std::size_t>(columns));
        const auto row = static_cast<float>(i / static_cast<std::size_t>(columns));
        ImGui::SetCursorScreenPos({start.x + column * (width + space), start.y + row * tall});
        drawPresetCard(session, presets, *cards[i], width);
        const bool reveal = !presets.revealed && cards[i]->entry.name == session.presetName;
        if (reveal) ImGui::SetScrollHereY();
    }
    const auto rows = std::ceil(static_cast<float>(cards.size()) / count);
    ImGui::SetCursorScreenPos({start.x, start.y + rows * tall});
    ImGui::Dummy({0.0f, 0.0f});
}

void drawGrid(Session& session, PresetBrowser& presets) {
    std::vector<const PresetCard*> own, bundled;
    for (const PresetCard& card : presets.cards) {
        if (isFound(card, presets.search)) (card.entry.bundled ? bundled : own).push_back(&card);
    }
    if (own.empty() && bundled.empty()) {
        ImGui::TextDisabled(presets.cards.empty() ? "There are no presets" : "No preset matches");
        return;
    }
    const float height =
        std::max(kGridEms * ImGui::GetFontSize(), kGridShare * ImGui::GetIO().DisplaySize.y);
    if (ImGui::BeginChild("##presets", {0.0f, height})) {
        drawSection(session, presets, "Mine", own);
        drawSection(session, presets, "Bundled", bundled);
        presets.revealed = true;
    }
    ImGui::EndChild();
    place("presets.grid");
}

/// A line each, broken where the column is too narrow.
void drawChanges(const std::vector<PresetDifference>& rows) {
    const auto lines = static_cast<float>(std::min(rows.size(), kChangeRows));
    if (ImGui::BeginChild("##changes", {0.0f, lines * ImGui::GetTextLineHeightWithSpacing()})) {
        for (const PresetDifference& row : rows) ImGui::TextWrapped("%s", lineOf(row).c_str());
    }
    ImGui::EndChild();
}

/// What the last preset changed, for as long as that can be undone at once.
void drawApplied(Session& session, const PresetApplied& applied) {
    if (applied.step.empty() || applied.rows.empty()) return;
    if (session.history.undoLabel() != applied.step) return;
    const bool open = ImGui::TreeNodeEx(
        "##applied", ImGuiTreeNodeFlags_SpanFullWidth | ImGuiTreeNodeFlags_AllowItemOverlap,
        "%zu %s by %s", applied.rows.size(), applied.rows.size() == 1 ? "change" : "changes",
        applied.name.c_str());
    place("presets.applied");
    const float width = ImGui::CalcTextSize("Undo").x + 2.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
    const bool undo = ImGui::SmallButton("Undo");
    place("presets.undo");
    if (open) {
        drawChanges(applied.rows);
        ImGui::TreePop();
    }
    if (undo) session.undo();
}

}  // namespace

void drawPresets(const PanelContext& context, PresetBrowser& presets) {
    const bool open = ImGui::CollapsingHeader("Presets", ImGuiTreeNodeFlags_DefaultOpen);
    place("presets");
    if (!open) {
        presets.revealed = false;  // to be found again when it is unfolded
        return;
    }
    Session& session = context.session();
    keepListed(context.services, presets);
    updateThumbnails(context, presets);
    drawLoaded(session);
    drawButtons(context.actions);
    drawSearch(presets);
    drawGrid(session, presets);
    drawApplied(session, presets.applied);
    drawPresetDetails(session, presets);
}

}  // namespace neph::ui
