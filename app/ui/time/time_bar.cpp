// time_bar.cpp: which time of the series, or place on the camera path, is shown; playing.
#include "app/ui/time/time_bar.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/time/path_lead.h"
#include "app/ui/time/transport_icons.h"
#include "app/ui/widgets/fixed_window.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"

namespace neph::ui {
namespace {

constexpr float kButtonEms = 1.75f;  // width
constexpr float kSpeedEms = 6.4f;
constexpr float kMemberEms = 9.0f;
constexpr double kLongestFrameS = 0.25;  // along a path: a hitch is no leap

std::string labelOf(const Session& session, int time) {
    return session.info()->times.at(static_cast<std::size_t>(time)).label;
}

/// Whether the image shows the document's time, as far as its own is known.
bool isReady(const Session& session, int imageTime) {
    if (!session.info()) return true;
    const int time = session.document.time;
    return session.shows(time) && (imageTime < 0 || imageTime == time);
}

void button(const ActionLookup& actions, const char* id, Icon icon) {
    const ActionFace face = actions.face(id);
    ImGui::BeginDisabled(!face.enabled);
    const bool pressed = iconButton(id, icon, kButtonEms * ImGui::GetFontSize(), face.on);
    ImGui::EndDisabled();
    place(id);
    tooltip(face.tooltip);
    if (pressed) actions.run(id);
    ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
}

void drawButtons(const ActionLookup& actions, bool playing) {
    button(actions, "time.first", Icon::first);
    button(actions, "time.before", Icon::before);
    button(actions, "time.play", playing ? Icon::pause : Icon::play);
    button(actions, "time.after", Icon::after);
    button(actions, "time.last", Icon::last);
    button(actions, "time.loop", Icon::loop);
}

/// Below the buttons: how fast, and how many times on with each step.
void drawSpeed(Playback& playback, int last, float width) {
    auto speed = static_cast<float>(playback.timesPerSecond);
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const float speedWidth = std::min(kSpeedEms * ImGui::GetFontSize(), 0.6f * width);
    ImGui::SetNextItemWidth(speedWidth);
    if (ImGui::DragFloat("##speed", &speed, 0.02f, static_cast<float>(kLeastTimesPerSecond),
                         static_cast<float>(kMostTimesPerSecond), "%.3g times/s",
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic)) {
        playback.timesPerSecond = static_cast<double>(speed);
    }
    place("time.speed");
    tooltip("Playback speed; drag, or Ctrl+click to type");
    ImGui::SameLine(0.0f, inner);
    ImGui::SetNextItemWidth(width - speedWidth - inner);
    ImGui::DragInt("##step", &playback.step, 0.05f, 1, std::max(1, last), "step %d",
                   ImGuiSliderFlags_AlwaysClamp);
    place("time.step");
    tooltip("Number of times to advance with each step of playback");
}

/// A '%' in a model's own label must not be read as a format.
std::string plain(const std::string& text) {
    std::string format;
    for (const char c : text) format += c == '%' ? std::string("%%") : std::string(1, c);
    return format;
}

/// Along the lower edge of the slider: the times that are in memory.
void markHeld(const Session& session) {
    const int last = lastTime(session);
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    const float width = upper.x - lower.x, height = std::round(0.14f * ImGui::GetFontSize());
    const ImU32 colour = ImGui::GetColorU32(ImGuiCol_CheckMark);
    // As ImGui places a slider's grab: a share of the track each, or as narrow as a grab may be.
    const float cell =
        std::max(width / static_cast<float>(last + 1), ImGui::GetStyle().GrabMinSize);
    const float apart = (width - cell) / static_cast<float>(last);
    for (int time = 0; time <= last; ++time) {
        if (!session.holds(time)) continue;
        const float middle = lower.x + cell / 2.0f + apart * static_cast<float>(time);
        ImGui::GetWindowDrawList()->AddRectFilled({middle - apart / 2.0f, upper.y - height},
                                                  {middle + apart / 2.0f, upper.y}, colour);
    }
}

void drawTimes(Session& session) {
    int& time = session.document.time;
    const int last = lastTime(session);
    time = std::clamp(time, 0, last);
    const std::string format =
        plain(fmt::format("{}   {} of {}", labelOf(session, time), time + 1, last + 1));
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::SliderInt("##slider", &time, 0, last, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    place("time.slider");
    tooltip("Times of the data. The line below marks those in memory.");
    markHeld(session);
}

void drawPath(Session& session, Playback& playback) {
    const double durationS = neph::durationS(session.document.path);
    auto atS = static_cast<float>(std::min(playback.atS, durationS));
    const std::string format = fmt::format("%.2f s of {:.4g} s along the camera path", durationS);
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::SliderFloat("##path", &atS, 0.0f, static_cast<float>(durationS), format.c_str(),
                           ImGuiSliderFlags_AlwaysClamp)) {
        playback.atS = static_cast<double>(atS);
        leadAlongPath(session, playback);
    }
    place("time.path");
}

/// The labels of the slider's ends, and between them what is waited for.
void drawEnds(const Session& session, bool playing, bool path) {
    const std::string first = path ? "0 s" : labelOf(session, 0);
    const std::string last = path ? fmt::format("{:.4g} s", durationS(session.document.path))
                                  : labelOf(session, lastTime(session));
    const float start = ImGui::GetCursorPosX();
    const float end = start + ImGui::GetContentRegionAvail().x;
    ImGui::TextDisabled("%s", first.c_str());
    const bool waits =
        playing && session.info() != nullptr && !session.shows(session.document.time);
    const std::string waiting =
        waits ? "waiting for " + labelOf(session, session.document.time) : std::string();
    const auto widthOf = [](const std::string& text) {
        return ImGui::CalcTextSize(text.c_str()).x;
    };
    const float room = end - start - widthOf(first) - widthOf(last);
    if (waits && room > widthOf(waiting) + 2.0f * ImGui::GetFontSize()) {
        ImGui::SameLine(start + widthOf(first) + (room - widthOf(waiting)) / 2.0f);
        ImGui::TextColored(warningColour(), "%s", waiting.c_str());
    }
    ImGui::SameLine(end - widthOf(last));
    ImGui::TextDisabled("%s", last.c_str());
}

/// Which member of an ensemble is shown.
void drawMembers(Session& session, float width) {
    const Ensemble& ensemble = *session.ensemble();
    int& shown = session.document.member;
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##member", ensemble.nameOf(shown).c_str())) {
        for (int member = kMeanMember; member < ensemble.count(); ++member) {
            const bool there =
                member == kMeanMember || ensemble.timeIn(member, session.document.time).has_value();
            const std::string name = ensemble.nameOf(member) + (there ? "" : " (lacks this time)");
            ImGui::PushID(member);
            if (ImGui::Selectable(
                    name.c_str(), member == shown,
                    there ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled)) {
                shown = member;
            }
            ImGui::PopID();
            place(fmt::format("member:{}", ensemble.nameOf(member)));
        }
        ImGui::EndCombo();
    }
    place("time.member");
    tooltip("The member of the ensemble that is shown, or the mean of all. " +
            std::string("Page Up and Page Down step through them."));
    ImGui::SameLine();
}

}  // namespace

void stepMember(Session& session, int steps) {
    const Ensemble* ensemble = session.ensemble();
    if (ensemble == nullptr) return;
    int& shown = session.document.member;
    const int time = session.document.time;
    const int way = steps < 0 ? -1 : 1;
    int member = shown == kMeanMember && way < 0 ? ensemble->count() : shown;
    for (member += way; member >= 0 && member < ensemble->count(); member += way) {
        if (ensemble->timeIn(member, time)) {
            shown = member;
            return;
        }
        session.say(Message::Kind::note, ensemble->lacking(member, time).message());
    }
}

int lastTime(const Session& session) {
    const DatasetInfo* info = session.info();
    return info == nullptr ? 0 : static_cast<int>(info->times.size()) - 1;
}

void playOn(const PanelContext& context, Playback& playback, int imageTime) {
    Session& session = context.session();
    if (!playback.playing) return;
    const auto seconds = static_cast<double>(ImGui::GetIO().DeltaTime);
    if (playback.alongPath) {
        advanceAlong(playback, std::min(seconds, kLongestFrameS), durationS(session.document.path),
                     isReady(session, imageTime));
        leadAlongPath(session, playback);
    } else {
        const auto next = advance(playback, seconds, session.document.time, lastTime(session) + 1,
                                  isReady(session, imageTime));
        if (next) session.document.time = *next;
    }
    context.next.animates |= playback.playing;
}

void drawTimeBar(const PanelContext& context, Playback& playback) {
    Session& session = context.session();
    const Area area = context.layout().time;
    if (area.empty()) return;
    const float em = ImGui::GetFontSize();
    const bool path = playback.alongPath || lastTime(session) < 1;
    if (beginFixed("##time", area.lower, area.size())) {
        const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
        const float left = ImGui::GetCursorPosX(), top = ImGui::GetCursorPosY();
        const float buttons = 6.0f * kButtonEms * em + 5.0f * inner;
        drawButtons(context.actions, playback.playing);
        ImGui::SetCursorPosX(left + buttons + em);
        if (session.ensemble() != nullptr) drawMembers(session, kMemberEms * em);
        if (path && lastTime(session) < 1 && session.document.path.keys.size() < 2) {
            ImGui::AlignTextToFramePadding();
            ImGui::TextUnformatted(session.info() ? labelOf(session, 0).c_str() : "");
        } else {
            path ? drawPath(session, playback) : drawTimes(session);
        }
        ImGui::SetCursorPos({left, top + ImGui::GetFrameHeightWithSpacing()});
        drawSpeed(playback, lastTime(session), buttons);
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + buttons + em);
        ImGui::AlignTextToFramePadding();
        const bool one = path && session.document.path.keys.size() < 2;
        if (!one) drawEnds(session, playback.playing, path);
    }
    ImGui::End();
}

}  // namespace neph::ui
