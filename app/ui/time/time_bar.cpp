// time_bar.cpp: which time of the series, or place on the camera path, is shown; playing.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/camera/camera_view.h"
#include "app/ui/shell/actions.h"
#include "app/ui/shell/panels.h"
#include "app/ui/time/transport_icons.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/layout.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"

namespace neph::ui {
namespace {

constexpr float kButtonEms = 1.75f;  // width
constexpr float kSpeedEms = 6.4f;
constexpr double kLongestFrameS = 0.25;  // along a path: a hitch is no leap

std::string labelOf(const Ui& ui, int time) {
    return ui.session().info()->times.at(static_cast<std::size_t>(time)).label;
}

/// Whether the picture shows the document's time. Of two pictures, or the other slot's, that is not
/// told.
bool isReady(const Ui& ui) {
    if (!ui.session().info()) return true;
    const int time = ui.session().document.time;
    const bool told =
        ui.report.time >= 0 && ui.compare.mode == CompareMode::single && !ui.compare.peeking;
    return ui.session().shows(time) && (!told || ui.report.time == time);
}

bool button(Ui& ui, const char* id, Icon icon) {
    const Action* action = findAction(id);
    if (action == nullptr) return false;
    const bool on = action->checked != nullptr && action->checked(ui);
    ImGui::BeginDisabled(!isEnabled(*action, ui));
    const bool pressed = iconButton(id, icon, kButtonEms * ImGui::GetFontSize(), on);
    ImGui::EndDisabled();
    place(id);
    tooltip(tooltipOf(*action));
    if (pressed) runAction(ui, id);
    ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
    return pressed;
}

void drawButtons(Ui& ui) {
    button(ui, "time.first", Icon::first);
    button(ui, "time.before", Icon::before);
    button(ui, "time.play", ui.playback.playing ? Icon::pause : Icon::play);
    button(ui, "time.after", Icon::after);
    button(ui, "time.last", Icon::last);
    button(ui, "time.loop", Icon::loop);
}

/// Below the buttons: how fast, and how many times on with each step.
void drawSpeed(Ui& ui, float width) {
    auto speed = static_cast<float>(ui.playback.timesPerSecond);
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const float speedWidth = std::min(kSpeedEms * ImGui::GetFontSize(), 0.6f * width);
    ImGui::SetNextItemWidth(speedWidth);
    if (ImGui::DragFloat("##speed", &speed, 0.02f, static_cast<float>(kLeastTimesPerSecond),
                         static_cast<float>(kMostTimesPerSecond), "%.3g times/s",
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic)) {
        ui.playback.timesPerSecond = static_cast<double>(speed);
    }
    place("time.speed");
    tooltip("How fast playing goes; drag, or Ctrl+click to type");
    ImGui::SameLine(0.0f, inner);
    ImGui::SetNextItemWidth(width - speedWidth - inner);
    ImGui::DragInt("##step", &ui.playback.step, 0.05f, 1, std::max(1, lastTime(ui)), "step %d",
                   ImGuiSliderFlags_AlwaysClamp);
    place("time.step");
    tooltip("How many times on with each step of playing");
}

/// A '%' in a model's own label must not be read as a format.
std::string plain(const std::string& text) {
    std::string format;
    for (const char c : text) format += c == '%' ? std::string("%%") : std::string(1, c);
    return format;
}

/// Along the lower edge of the slider: the times that are in memory.
void markHeld(const Ui& ui) {
    const int last = lastTime(ui);
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    const float width = upper.x - lower.x, height = std::round(0.14f * ImGui::GetFontSize());
    const ImU32 colour = ImGui::GetColorU32(ImGuiCol_CheckMark);
    // As ImGui places a slider's grab: a share of the track each, or as narrow as a grab may be.
    const float cell =
        std::max(width / static_cast<float>(last + 1), ImGui::GetStyle().GrabMinSize);
    const float apart = (width - cell) / static_cast<float>(last);
    for (int time = 0; time <= last; ++time) {
        if (!ui.session().holds(time)) continue;
        const float middle = lower.x + cell / 2.0f + apart * static_cast<float>(time);
        ImGui::GetWindowDrawList()->AddRectFilled({middle - apart / 2.0f, upper.y - height},
                                                  {middle + apart / 2.0f, upper.y}, colour);
    }
}

void drawTimes(Ui& ui) {
    int& time = ui.session().document.time;
    const int last = lastTime(ui);
    time = std::clamp(time, 0, last);
    const std::string format =
        plain(fmt::format("{}   {} of {}", labelOf(ui, time), time + 1, last + 1));
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::SliderInt("##slider", &time, 0, last, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    place("time.slider");
    tooltip("Times of the data. The line below marks those in memory.");
    markHeld(ui);
}

void drawPath(Ui& ui) {
    const double durationS = neph::durationS(ui.session().document.path);
    auto atS = static_cast<float>(std::min(ui.playback.atS, durationS));
    const std::string format = fmt::format("%.2f s of {:.4g} s along the camera path", durationS);
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::SliderFloat("##path", &atS, 0.0f, static_cast<float>(durationS), format.c_str(),
                           ImGuiSliderFlags_AlwaysClamp)) {
        ui.playback.atS = static_cast<double>(atS);
        leadAlongPath(ui);
    }
    place("time.path");
}

/// The labels of the slider's ends, and between them what is waited for.
void drawEnds(const Ui& ui, bool path) {
    const std::string first = path ? "0 s" : labelOf(ui, 0);
    const std::string last = path ? fmt::format("{:.4g} s", durationS(ui.session().document.path))
                                  : labelOf(ui, lastTime(ui));
    const float start = ImGui::GetCursorPosX();
    const float end = start + ImGui::GetContentRegionAvail().x;
    ImGui::TextDisabled("%s", first.c_str());
    const bool waits = ui.playback.playing && ui.session().info() != nullptr &&
                       !ui.session().shows(ui.session().document.time);
    const std::string waiting =
        waits ? "waiting for " + labelOf(ui, ui.session().document.time) : std::string();
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

}  // namespace

int lastTime(const Ui& ui) {
    const DatasetInfo* info = ui.session().info();
    return info == nullptr ? 0 : static_cast<int>(info->times.size()) - 1;
}

void playOn(Ui& ui) {
    Playback& playback = ui.playback;
    if (!playback.playing) return;
    const auto seconds = static_cast<double>(ImGui::GetIO().DeltaTime);
    if (playback.alongPath) {
        advanceAlong(playback, std::min(seconds, kLongestFrameS),
                     durationS(ui.session().document.path), isReady(ui));
        leadAlongPath(ui);
    } else {
        const auto next =
            advance(playback, seconds, ui.session().document.time, lastTime(ui) + 1, isReady(ui));
        if (next) ui.session().document.time = *next;
    }
    ui.animates |= playback.playing;
}

void drawTimeBar(Ui& ui) {
    const Area area = layoutOf(ui).time;
    if (area.empty()) return;
    const float em = ImGui::GetFontSize();
    const bool path = ui.playback.alongPath || lastTime(ui) < 1;
    if (beginFixed("##time", area.lower, area.size())) {
        const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
        const float left = ImGui::GetCursorPosX(), top = ImGui::GetCursorPosY();
        const float buttons = 6.0f * kButtonEms * em + 5.0f * inner;
        drawButtons(ui);
        ImGui::SetCursorPosX(left + buttons + em);
        path ? drawPath(ui) : drawTimes(ui);
        ImGui::SetCursorPos({left, top + ImGui::GetFrameHeightWithSpacing()});
        drawSpeed(ui, buttons);
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + buttons + em);
        ImGui::AlignTextToFramePadding();
        drawEnds(ui, path);
    }
    ImGui::End();
}

}  // namespace neph::ui
