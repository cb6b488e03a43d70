// session_dialogs.cpp: the dialogue for data that have moved, and the offer after a crash.
#include "app/ui/data/session_dialogs.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <ctime>
#include <utility>

#include "app/ui/data/path_popup.h"
#include "app/ui/panel/notice_box.h"
#include "app/ui/widgets/dialogue.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"
#include "core/base/error.h"
#include "core/session/autosave.h"
#include "core/session/moved_data.h"
#include "core/session/recent.h"
#include "core/session/session_file.h"

namespace neph::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMissingShown = 6;
constexpr float kMovedEms = 36.0f;

std::string dataText(const SessionState& state) {
    const SlotState& slot = state.slots[static_cast<std::size_t>(state.active)];
    if (slot.data.empty()) return "the bundled storm";
    const std::string name = fs::path(slot.data.front()).filename().string();
    return slot.data.size() == 1 ? name : fmt::format("{} and {} more", name, slot.data.size() - 1);
}

/// "The last session ended unexpectedly 3 minutes ago (wrfout_d01, saved 12:31)."
std::string crashText(const LeftSession& left) {
    const double ago = std::difftime(std::time(nullptr), left.savedAt);
    std::string what = "it cannot be read";
    try {
        what = dataText(loadSession(left.file));
    } catch (const Error&) {  // told when it is asked for
    }
    return fmt::format("The last session ended unexpectedly {} ({}, saved at {:%H:%M}).",
                       agoText(ago), what, fmt::localtime(left.savedAt));
}

void drawMissing(const WaitingSession& waiting) {
    ImGui::PushTextWrapPos(itemWidth(kMovedEms));
    ImGui::TextUnformatted((waiting.name + ": these data are no longer where they were:").c_str());
    ImGui::Indent();
    for (std::size_t i = 0; i < std::min(kMissingShown, waiting.missing.size()); ++i) {
        wantGlyphs(waiting.missing[i]);
        ImGui::TextUnformatted(waiting.missing[i].c_str());
    }
    if (waiting.missing.size() > kMissingShown) {
        ImGui::Text("and %zu more", waiting.missing.size() - kMissingShown);
    }
    ImGui::Unindent();
    ImGui::Spacing();
    ImGui::TextUnformatted(
        "Where is the first of them now? The others will be looked for near it.");
    ImGui::PopTextWrapPos();
}

/// False when the dialogue is done with.
bool drawQuestion(const PanelContext& context, SessionDialogs& dialogs, WaitingSession& waiting) {
    drawMissing(waiting);
    ImGui::SetNextItemWidth(itemWidth(30.0f));
    const bool entered =
        ImGui::InputText("##moved", &waiting.line, ImGuiInputTextFlags_EnterReturnsTrue);
    place("moved.line");
    beside("Browse...");
    if (ImGui::Button("Browse...")) browse(context.settings, dialogs, BrowseFor::moved);
    place("moved.browse");
    ImGui::TextDisabled("%s", waiting.told.c_str());
    if (ImGui::Button("Look there") || entered) answer(waiting, waiting.line);
    place("moved.look");
    beside("Open without them");
    if (ImGui::Button("Open without them")) leaveOut(context.session(), waiting);
    place("moved.without");
    tooltip("Uses the session's look and camera with the data that are open now");
    beside("Cancel");
    const bool left = ImGui::Button("Cancel");
    place("moved.cancel");
    const bool escape = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    drawPathPopup(context, dialogs);  // on top of this one
    return !left && !(escape && !ImGui::IsPopupOpen("###files"));
}

/// All that was opened recently.
void drawRecent(const PanelContext& context, SessionDialogs& dialogs) {
    if (std::exchange(dialogs.showRecent, false)) ImGui::OpenPopup("Recent");
    if (!beginModal("Recent", dialogueWidth(44.0f))) return;
    const std::string chosen = drawRecentList(context, dialogs, kMaxRecent);
    ImGui::Spacing();
    if (ImGui::Button("Clear the list")) context.settings.recent.clear();
    place("recent.clear");
    ImGui::SameLine();
    const bool left =
        ImGui::Button("Close") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    place("recent.close");
    if (left || !chosen.empty() || context.settings.recent.empty()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (!chosen.empty()) openRecent(context, dialogs, chosen);
}

}  // namespace

void drawCrashNotice(const PanelContext& context, SessionDialogs& dialogs) {
    const LeftSession* left =
        dialogs.autosave == nullptr || dialogs.waiting ? nullptr : dialogs.autosave->crashed();
    if (left == nullptr || !dialogs.offersCrashed) return;
    if (dialogs.crashText.empty()) dialogs.crashText = crashText(*left);
    bool restore = false, discard = false;
    if (beginNotice(context.layout().image, "##crashed", NoticeAt::top)) {
        ImGui::TextUnformatted(dialogs.crashText.c_str());
        restore = ImGui::Button("Restore");
        place("crash.restore");
        ImGui::SameLine();
        discard = ImGui::Button("Discard");
        place("crash.discard");
    }
    endNotice();
    if (restore) {
        dialogs.offersCrashed = false;
        reopenLast(context, dialogs);
    }
    if (discard) {
        dialogs.autosave->discardCrashed();
        dialogs.crashText.clear();
    }
}

std::string drawRecentList(const PanelContext& context, SessionDialogs& dialogs,
                           std::size_t count) {
    const std::vector<std::string>& recent = context.settings.recent;
    const float em = ImGui::GetFontSize();
    std::string chosen;
    for (std::size_t i = 0; i < std::min(count, recent.size()); ++i) {
        const RecentLabel label = labelOf(recent[i]);
        const bool there = recentIsThere(dialogs, recent, i);
        wantGlyphs(recent[i]);
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable("##entry", false,
                              there ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled,
                              {0.0f, ImGui::GetTextLineHeight()})) {
            chosen = recent[i];
        }
        place(fmt::format("recent:{}", i));
        tooltip(recent[i] + (there ? "" : "\nNo longer there"));
        ImGui::SameLine(0.5f * em);
        ImGui::TextColored(ImGui::GetStyle().Colors[there ? ImGuiCol_Text : ImGuiCol_TextDisabled],
                           "%s", label.name.c_str());
        ImGui::SameLine();
        ImGui::TextDisabled("%s", there ? label.folder.c_str() : "no longer there");
        ImGui::PopID();
    }
    return chosen;
}

void drawSessionDialogs(const PanelContext& context, SessionDialogs& dialogs) {
    noteOpened(context, dialogs);
    drawRecent(context, dialogs);
    std::optional<WaitingSession>& waiting = dialogs.waiting;
    const char* title = "Where are the data?";
    if (waiting && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    if (!beginModal(title)) return;
    if (waiting && !drawQuestion(context, dialogs, *waiting)) waiting.reset();
    if (waiting && waiting->missing.empty()) {
        takeOver(context, dialogs, *std::exchange(waiting, std::nullopt));
    }
    if (!waiting) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace neph::ui
