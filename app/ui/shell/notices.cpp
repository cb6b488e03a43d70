// notices.cpp: loading, errors and empty states over the picture; the list of messages when asked.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/shell/panels.h"
#include "app/ui/widgets/layout.h"
#include "app/ui/widgets/notice_box.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"
#include "core/session/autosave.h"
#include "core/session/recent.h"

namespace neph::ui {
namespace {

constexpr float kNoticeEms = 34.0f;
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

void drawLoading(const Ui& ui, Session& session) {
    if (beginNotice(ui, "##loading", NoticeAt::middle)) {
        ImGui::TextUnformatted(session.loadingLabel().c_str());
        const float em = ImGui::GetFontSize();
        ImGui::ProgressBar(static_cast<float>(session.loadingFraction()), {16.0f * em, 0.0f});
        ImGui::SameLine();
        if (ImGui::Button("Cancel")) session.cancelLoading();
        place("loading.cancel");
    }
    endNotice();
}

void drawError(Ui& ui, const std::string& text) {
    bool close = false;
    if (beginNotice(ui, "##error", NoticeAt::top)) {
        ImGui::TextColored(errorColour(), "Error");
        ImGui::TextUnformatted(text.c_str());
        close = ImGui::Button("Close");
        place("error.close");
        ImGui::SameLine();
        if (ImGui::Button("Copy")) ImGui::SetClipboardText(text.c_str());
        place("error.copy");
    }
    endNotice();
    if (close) ui.dismissedSerial = ui.session().messages.back().serial;
}

/// What there is to do when nothing is open.
void drawStart(Ui& ui) {
    std::string wanted;
    if (beginNotice(ui, "##nodata", NoticeAt::middle)) {
        title("No data");
        ImGui::TextUnformatted("Drop model output on the window: files, or the folder of a run.");
        ImGui::Spacing();
        if (ImGui::Button("Open data...")) browse(ui, BrowseFor::data);
        place("start.open");
        ImGui::SameLine();
        if (ImGui::Button("Open the bundled storm")) ui.session().open({});
        place("start.bundled");
        if (canReopenLast(ui)) {
            ImGui::SameLine();
            if (ImGui::Button("Reopen last session")) reopenLast(ui);
            place("start.reopen");
        }
        if (!ui.settings.recent.empty()) {
            ImGui::Spacing();
            title("Opened lately");
            wanted = drawRecentList(ui, kRecentShown);
        }
    }
    endNotice();
    if (!wanted.empty()) openFiles(ui, namesIn(wanted));
}

void drawNoHydrometeors(const Ui& ui, const DatasetInfo& info) {
    std::string names;
    for (std::size_t i = 0; i < std::min(kVariablesShown, info.variables.size()); ++i) {
        names += (i == 0 ? "" : ", ") + info.variables[i].name;
    }
    if (info.variables.size() > kVariablesShown) {
        names += fmt::format(" and {} more", info.variables.size() - kVariablesShown);
    }
    if (beginNotice(ui, "##nohydrometeors", NoticeAt::middle)) {
        title("No hydrometeors");
        ImGui::TextUnformatted(
            "These data hold none of what can be seen: cloud, rain, ice, snow, graupel or hail, as "
            "mixing ratios (WRF: QCLOUD, QRAIN, QICE, QSNOW, QGRAUP, QHAIL).");
        ImGui::TextUnformatted(names.empty() ? "No variable was recognised."
                                             : ("Found: " + names + ".").c_str());
    }
    endNotice();
}

void drawClearSky(Ui& ui, const VolumeSummary& shown) {
    const bool part = ui.session().region().has_value();
    if (beginNotice(ui, "##clear", NoticeAt::middle)) {
        title("Clear sky");
        ImGui::Text("There is no hydrometeor%s at %s.", part ? " in this part of the domain" : "",
                    shown.timeLabel.c_str());
        if (part && ImGui::Button("Show the whole domain")) ui.session().setRegion({});
        place("clear.whole");
    }
    endNotice();
}

void drawAllOff(Ui& ui) {
    if (beginNotice(ui, "##off", NoticeAt::middle)) {
        ImGui::TextUnformatted("Every field is switched off.");
        if (ImGui::Button("Show all fields")) showAllFields(ui.session().document.look);
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
void drawState(Ui& ui) {
    Session& session = ui.session();
    const VolumeSummary* shown = session.shown();
    const bool opening = session.loading() && session.loadingLabel().starts_with("Opening");
    if (opening || (session.loading() && shown == nullptr)) {
        drawLoading(ui, session);
    } else if (shown == nullptr) {
        drawStart(ui);
    } else if (session.info() != nullptr && !hasHydrometeors(*session.info())) {
        drawNoHydrometeors(ui, *session.info());
    } else if (shown->empty()) {
        drawClearSky(ui, *shown);
    } else if (everyFieldOff(session.document.look, *shown)) {
        drawAllOff(ui);
    }
}

const std::string* newestError(const Ui& ui) {
    const std::uint64_t seen = std::max(ui.dismissedSerial, ui.session().settledSerial);
    const auto& messages = ui.session().messages;
    const auto found = std::find_if(messages.rbegin(), messages.rend(), [&](const Message& m) {
        return m.kind == Message::Kind::error && m.serial > seen;
    });
    return found == messages.rend() ? nullptr : &found->text;
}

void drawMessages(Ui& ui) {
    const float em = ImGui::GetFontSize();
    const Area picture = layoutOf(ui).picture;
    const glm::vec2 corner = picture.lower;
    ImGui::SetNextWindowSize(
        {std::min(kMessagesEms * em, picture.size().x - 2.0f * em), 18.0f * em},
        ImGuiCond_Appearing);
    ImGui::SetNextWindowPos({corner.x + em, corner.y + em}, ImGuiCond_Appearing);
    if (ImGui::Begin("Messages", &ui.showMessages,
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing)) {
        ImGui::PushTextWrapPos(0.0f);
        for (const Message& message : ui.session().messages) {
            const char* kind = message.kind == Message::Kind::error     ? "error: "
                               : message.kind == Message::Kind::warning ? "warning: "
                                                                        : "";
            ImGui::TextUnformatted((kind + message.text).c_str());
        }
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

}  // namespace

bool beginNotice(const Ui& ui, const char* name, NoticeAt at) {
    const Area picture = layoutOf(ui).picture;
    const float em = ImGui::GetFontSize();
    const glm::vec2 room = glm::max(picture.size() - 2.0f * em, glm::vec2(4.0f * em));
    const float width = std::min(kNoticeEms * em, room.x);
    const float share = at == NoticeAt::top ? 0.0f : at == NoticeAt::middle ? 0.5f : 1.0f;
    const float top = picture.lower.y + em + share * room.y;
    ImGui::SetNextWindowPos({(picture.lower.x + picture.upper.x) / 2.0f, top}, ImGuiCond_Always,
                            {0.5f, share});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {width, room.y});
    const bool open =
        ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(width - 2.0f * ImGui::GetStyle().WindowPadding.x);
    return open;
}

void endNotice() {
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void drawNotices(Ui& ui) {
    drawState(ui);
    drawCrashNotice(ui);
    if (const std::string* error = newestError(ui)) drawError(ui, *error);
    if (ui.showMessages) drawMessages(ui);
}

}  // namespace neph::ui
