// notices.cpp: loading, errors and empty states over the image; the list of messages when asked.
#include "app/ui/shell/notices.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/data/session_dialogs.h"
#include "app/ui/panel/notice_box.h"
#include "app/ui/widgets/dialogue.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"
#include "core/session/autosave.h"
#include "core/session/recent.h"

namespace neph::ui {
namespace {

constexpr float kMessagesEms = 40.0f;
constexpr std::size_t kRecentShown = 6;      // on the start screen; the list of all is a dialogue
constexpr std::size_t kVariablesShown = 16;  // of a file without hydrometeors

/// Whether all that the data have is switched off.
bool everyFieldOff(const Look& look, const VolumeSummary& shown) {
    for (std::size_t i = 0; i < look.species.size(); ++i) {
        if (shown.present[i] && look.species[i].visible) return false;
    }
    return true;
}

void showAllFields(Look& look) {
    for (SpeciesLook& s : look.species) s.visible = true;
}

void title(const char* text) {
    ImGui::TextColored(ImGui::GetStyle().Colors[ImGuiCol_CheckMark], "%s", text);
}

void drawLoading(const Area& image, Session& session) {
    if (beginNotice(image, "##loading", NoticeAt::middle)) {
        wantGlyphs(session.loadingLabel());
        ImGui::TextUnformatted(session.loadingLabel().c_str());
        const float em = ImGui::GetFontSize();
        const float width = noticeWidth(image);
        ImGui::ProgressBar(static_cast<float>(session.loadingFraction()),
                           {std::min(16.0f * em, width - 2.0f * em), 0.0f});
        beside("Cancel", width);
        if (ImGui::Button("Cancel")) session.cancelLoading();
        place("loading.cancel");
    }
    endNotice();
}

/// True when it is closed.
bool drawError(const Area& image, const std::string& text) {
    bool close = false;
    if (beginNotice(image, "##error", NoticeAt::top)) {
        wantGlyphs(text);
        ImGui::TextColored(errorColour(), "Error");
        ImGui::TextUnformatted(text.c_str());
        close = ImGui::Button("Close");
        place("error.close");
        ImGui::SameLine();
        if (ImGui::Button("Copy")) ImGui::SetClipboardText(text.c_str());
        place("error.copy");
    }
    endNotice();
    return close;
}

/// What there is to do when nothing is open.
void drawStart(const PanelContext& context, SessionDialogs& dialogs) {
    std::string wanted;
    const Area image = context.layout().image;
    const float width = noticeWidth(image);
    if (beginNotice(image, "##nodata", NoticeAt::middle)) {
        title("No data");
        ImGui::TextUnformatted("Drop model output on the window: files, or the folder of a run.");
        ImGui::Spacing();
        if (ImGui::Button("Open data...")) browse(context.settings, dialogs, BrowseFor::data);
        place("start.open");
        beside("Open the bundled storm", width);
        if (ImGui::Button("Open the bundled storm")) context.session().open({});
        place("start.bundled");
        if (canReopenLast(dialogs)) {
            beside("Reopen last session", width);
            if (ImGui::Button("Reopen last session")) reopenLast(context, dialogs);
            place("start.reopen");
        }
        if (!context.settings.recent.empty()) {
            ImGui::Spacing();
            title("Recent");
            wanted = drawRecentList(context, dialogs, kRecentShown);
        }
    }
    endNotice();
    if (!wanted.empty()) openRecent(context, dialogs, wanted);
}

void drawNoHydrometeors(const Area& image, const DatasetInfo& info) {
    std::string names;
    for (std::size_t i = 0; i < std::min(kVariablesShown, info.variables.size()); ++i) {
        names += (i == 0 ? "" : ", ") + info.variables[i].name;
    }
    if (info.variables.size() > kVariablesShown) {
        names += fmt::format(" and {} more", info.variables.size() - kVariablesShown);
    }
    if (beginNotice(image, "##nohydrometeors", NoticeAt::middle)) {
        title("No hydrometeors");
        ImGui::TextUnformatted(
            "These data hold none of what can be seen: cloud, rain, ice, snow, graupel or hail, as "
            "mixing ratios (WRF: QCLOUD, QRAIN, QICE, QSNOW, QGRAUP, QHAIL).");
        ImGui::TextUnformatted(names.empty() ? "No variable was recognised."
                                             : ("Found: " + names + ".").c_str());
    }
    endNotice();
}

void drawClearSky(const Area& image, Session& session, const VolumeSummary& shown) {
    const bool part = session.region().has_value();
    if (beginNotice(image, "##clear", NoticeAt::middle)) {
        title("Clear sky");
        ImGui::Text("There is no hydrometeor%s at %s.", part ? " in this part of the domain" : "",
                    shown.timeLabel.c_str());
        if (part && ImGui::Button("Show the whole domain")) session.setRegion({});
        place("clear.whole");
    }
    endNotice();
}

void drawAllOff(const Area& image, Look& look) {
    if (beginNotice(image, "##off", NoticeAt::middle)) {
        ImGui::TextUnformatted("Every field is switched off.");
        if (ImGui::Button("Show all fields")) showAllFields(look);
        place("off.show");
    }
    endNotice();
}

bool hasHydrometeors(const DatasetInfo& info) {
    return std::ranges::any_of(info.variables, [](const VariableInfo& variable) {
        return variable.role == VariableRole::mixingRatio && variable.species;
    });
}

/// What there is to say when there is nothing to see.
void drawState(const PanelContext& context, SessionDialogs& dialogs) {
    Session& session = context.session();
    const Area image = context.layout().image;
    const VolumeSummary* shown = session.shown();
    if (session.loading() && (session.opening() || shown == nullptr)) {
        drawLoading(image, session);
    } else if (shown == nullptr) {
        drawStart(context, dialogs);
    } else if (session.info() != nullptr && !hasHydrometeors(*session.info())) {
        drawNoHydrometeors(image, *session.info());
    } else if (shown->empty()) {
        drawClearSky(image, session, *shown);
    } else if (everyFieldOff(session.document.look, *shown)) {
        drawAllOff(image, session.document.look);
    }
}

const std::string* newestError(const Session& session, std::uint64_t dismissedSerial) {
    const std::uint64_t seen = std::max(dismissedSerial, session.settledSerial);
    const auto& messages = session.messages;
    const auto found = std::find_if(messages.rbegin(), messages.rend(), [&](const Message& m) {
        return m.kind == Message::Kind::error && m.serial > seen;
    });
    return found == messages.rend() ? nullptr : &found->text;
}

}  // namespace

void drawNotices(const PanelContext& context, SessionDialogs& dialogs,
                 std::uint64_t& dismissedSerial) {
    drawState(context, dialogs);
    drawCrashNotice(context, dialogs);
    const Session& session = context.session();
    const std::string* error = newestError(session, dismissedSerial);
    if (error != nullptr && drawError(context.layout().image, *error)) {
        dismissedSerial = session.messages.back().serial;
    }
}

void drawKeyHint(const PanelContext& context, std::uint64_t dismissedSerial, bool& shown) {
    const Session& session = context.session();
    // Other notices come first.
    if (session.shown() == nullptr || newestError(session, dismissedSerial) != nullptr) return;
    if (beginNotice(context.layout().image, "##keys", NoticeAt::top)) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted("H lists mouse and keys; Ctrl+P finds any command or parameter.");
        beside("Close", noticeWidth(context.layout().image));
        if (ImGui::Button("Close")) shown = false;
        place("hint.close");
    }
    endNotice();
}

void drawMessages(const PanelContext& context, bool& shown) {
    const float em = ImGui::GetFontSize();
    const Area image = context.layout().image;
    const glm::vec2 corner = image.lower;
    const glm::vec2 room = image.size() - 2.0f * em;
    ImGui::SetNextWindowSize({std::min(kMessagesEms * em, room.x), std::min(18.0f * em, room.y)},
                             ImGuiCond_Appearing);
    ImGui::SetNextWindowPos({corner.x + em, corner.y + em}, ImGuiCond_Appearing);
    if (ImGui::Begin("Messages", &shown,
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing)) {
        ImGui::PushTextWrapPos(0.0f);
        for (const Message& message : context.session().messages) {
            const char* kind = message.kind == Message::Kind::error     ? "error: "
                               : message.kind == Message::Kind::warning ? "warning: "
                                                                        : "";
            ImGui::TextUnformatted((kind + message.text).c_str());
        }
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

}  // namespace neph::ui
