// notices.cpp: loading, errors and empty states over the picture; the list of messages when asked.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/panels.h"

namespace neph::ui {
namespace {

constexpr float kNoticeEms = 34.0f;
constexpr float kMessagesEms = 40.0f;

bool everyFieldOff(const Look& look) {
    return std::none_of(look.species.begin(), look.species.end(),
                        [](const SpeciesLook& s) { return s.visible; });
}

void showAllFields(Look& look) {
    for (SpeciesLook& s : look.species) s.visible = true;
}

/// A box over the picture, `share` of the way down; pair with ImGui::End().
bool beginNotice(const char* name, float share) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2.0f, display.y * share}, ImGuiCond_Always, {0.5f, 0.0f});
    const bool open =
        ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(kNoticeEms * ImGui::GetFontSize());
    return open;
}

void endNotice() {
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void drawLoading(const Session& session) {
    if (beginNotice("##loading", 0.45f)) {
        ImGui::TextUnformatted(session.loadingLabel().c_str());
        ImGui::ProgressBar(static_cast<float>(session.loadingFraction()),
                           {20.0f * ImGui::GetFontSize(), 0.0f});
    }
    endNotice();
}

void drawError(Ui& ui, const std::string& text) {
    if (beginNotice("##error", 0.06f)) {
        ImGui::TextColored({0.95f, 0.55f, 0.45f, 1.0f}, "Error");
        ImGui::TextUnformatted(text.c_str());
        if (ImGui::Button("Close")) ui.dismissedSerial = ui.session().messages.back().serial;
    }
    endNotice();
}

void drawText(const char* name, const std::string& text) {
    if (beginNotice(name, 0.45f)) ImGui::TextUnformatted(text.c_str());
    endNotice();
}

/// What there is to say when there is nothing to see.
void drawEmpty(Ui& ui) {
    const Session& session = ui.session();
    if (!session.shown()) {
        drawText("##nodata", "No data. Drop model output on the window, or press Ctrl+O.");
    } else if (session.shown()->empty()) {
        drawText("##clear", fmt::format("Clear sky: there is no hydrometeor at {}.",
                                        session.shown()->timeLabel));
    } else if (everyFieldOff(session.document.look)) {
        if (beginNotice("##off", 0.45f)) {
            ImGui::TextUnformatted("Every field is switched off.");
            if (ImGui::Button("Show all fields")) showAllFields(ui.session().document.look);
        }
        endNotice();
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
    ImGui::SetNextWindowSize({kMessagesEms * em, 18.0f * em}, ImGuiCond_Appearing);
    const glm::vec2 corner = layoutOf(ui).picture.lower;
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

void drawNotices(Ui& ui) {
    if (ui.session().loading() && !ui.session().shown()) {
        drawLoading(ui.session());
    } else {
        drawEmpty(ui);
    }
    if (const std::string* error = newestError(ui)) drawError(ui, *error);
    if (ui.showMessages) drawMessages(ui);
}

}  // namespace neph::ui
