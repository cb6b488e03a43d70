// number_slider.cpp: positions are shares of the track, 0 at its left stop.
//
// A drag moves by what the mouse moved, so that it can go on more finely when Shift is pressed on
// the way. Only one slider has the hand or is typed into at a time: that state is here.
#include "app/ui/widgets/number_slider.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/ui/widgets/input.h"
#include "app/ui/widgets/words.h"

namespace neph::ui {
namespace {

constexpr double kFine = 0.1;
constexpr double kLogDepth = 1e-5;  // of the upper bound: where a logarithm begins that has a zero
constexpr float kGrabMargin = 2.0f;

struct Hand {
    double at = 0.0;    // share of the track; beyond its ends where the mouse is
    bool fine = false;  // the slider was last moved with Shift
};
struct Typing {
    ImGuiID id = 0;
    std::string text, fault;
    bool begun = false;  // has the keyboard
    int frame = 0;       // last drawn
};
Hand hand;
Typing typing;

double floorOf(const NumberRange& range) {
    return range.lo > 0.0 ? range.lo : range.hi * kLogDepth;
}

double shareOf(double value, const NumberRange& range) {
    if (!range.log) return (value - range.lo) / (range.hi - range.lo);
    const double floor = floorOf(range);
    return value <= floor ? 0.0 : std::log(value / floor) / std::log(range.hi / floor);
}

double valueAt(double share, const NumberRange& range) {
    if (share >= 1.0) return range.hi;
    if (share <= 0.0) return range.lo;
    if (!range.log) return range.lo + (range.hi - range.lo) * share;
    const double floor = floorOf(range);
    return floor * std::pow(range.hi / floor, share);
}

/// The value at a place of the track, rounded to a decimal as fine as one pixel can choose.
double tidyAt(double share, double sharePerPx, const NumberRange& range) {
    const double value = valueAt(share, range);
    if (share <= 0.0 || share >= 1.0) return value;
    if (range.whole) return std::round(value);
    const double px = std::abs(valueAt(share + sharePerPx, range) - value) +
                      std::abs(value - valueAt(share - sharePerPx, range));
    if (px <= 0.0) return value;
    const double step = std::pow(10.0, std::floor(std::log10(px / 2.0)));
    return std::clamp(std::round(value / step) * step, range.lo, range.hi);
}

/// A number, with or without its unit.
std::optional<double> parse(const std::string& typed, const std::string& unit) {
    std::string_view text = trimmed(typed);
    const std::string_view suffix = trimmed(unit);
    if (!suffix.empty() && text.ends_with(suffix)) {
        text = trimmed(text.substr(0, text.size() - suffix.size()));
    }
    const std::string pointed = withDecimalPoint(text);
    text = pointed;
    const std::size_t plus = text.starts_with('+') ? 1 : 0;
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + plus, end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) return {};
    return value;
}

/// Takes over what was typed; false where it is not a number.
bool take(double& value, const NumberRange& range, const std::string& unit, bool& changed) {
    const std::optional<double> typed = parse(typing.text, unit);
    if (!typed) return false;
    const double fit = std::clamp(*typed, range.lo, range.hi);
    const double wanted = range.whole ? std::round(fit) : fit;
    changed = wanted != value;
    value = wanted;
    return true;
}

void showFault() {
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect(lower, upper, IM_COL32(230, 90, 80, 255),
                                        ImGui::GetStyle().FrameRounding, 0, 1.5f);
    nextTooltipBeside(lastItem());
    ImGui::SetTooltip("%s", typing.fault.c_str());
}

bool typeIn(double& value, const NumberRange& range, const std::string& unit) {
    typing.frame = ImGui::GetFrameCount();
    const bool first = !typing.begun;
    if (first) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputText("##typed", &typing.text,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    typing.begun |= ImGui::IsItemActive();
    bool changed = false;
    if (entered) {
        if (take(value, range, unit, changed)) {
            typing = {};
            return changed;
        }
        typing.fault = "\"" + typing.text + "\" is not a number. Enter takes one" +
                       (trimmed(unit).empty() ? "" : " in " + std::string(trimmed(unit))) +
                       ", Esc leaves it.";
        if (typing.text.find(',') != typing.text.npos) {
            typing.fault += " Decimals follow a point, and nothing groups thousands.";
        }
        typing.begun = false;  // Enter took the keyboard away
    } else if (ImGui::IsItemEdited()) {
        typing.fault.clear();
    } else if (!first && typing.begun && !ImGui::IsItemActive()) {
        if (!escaped) take(value, range, unit, changed);
        typing = {};
        return changed;
    }
    if (!typing.fault.empty()) showFault();
    return changed;
}

struct Track {
    float left = 0.0f;   // of the middle of the grab at the left stop
    float width = 1.0f;  // that its middle travels
    float grab = 1.0f;
};

Track trackOf(ImVec2 at, float width) {
    const float grab = std::min(ImGui::GetStyle().GrabMinSize, width / 2.0f);
    const float room = std::max(1.0f, width - grab - 2.0f * kGrabMargin);
    return {at.x + kGrabMargin + grab / 2.0f, room, grab};
}

/// What the mouse does with the slider that it holds.
bool drag(double& value, const NumberRange& range, const Track& track) {
    const ImGuiIO& io = ImGui::GetIO();
    const double width = static_cast<double>(track.width);
    const double fine = io.KeyShift ? kFine : 1.0;
    bool moved = false;
    if (ImGui::IsItemActivated()) {
        hand.at = std::clamp(shareOf(value, range), 0.0, 1.0);
        const float grabbed = track.left + track.width * static_cast<float>(hand.at);
        const bool onGrab = std::abs(io.MousePos.x - grabbed) <= track.grab / 2.0f + kGrabMargin;
        hand.fine = io.KeyShift;
        if (onGrab || io.KeyShift) return false;  // it does not jump
        hand.at = static_cast<double>(io.MousePos.x - track.left) / width;
        moved = true;
    } else if (io.MouseDelta.x != 0.0f) {
        // From coarse to fine it goes on where the value is, not where the mouse is.
        if (hand.fine != io.KeyShift) hand.at = shareOf(value, range);
        hand.fine = io.KeyShift;
        hand.at += static_cast<double>(io.MouseDelta.x) / width * fine;
        moved = true;
    }
    if (!moved) return false;
    const double wanted = tidyAt(hand.at, fine / width, range);
    if (wanted == value) return false;
    value = wanted;
    return true;
}

void show(ImVec2 lower, ImVec2 upper, double share, const Track& track, const std::string& text) {
    const ImGuiStyle& style = ImGui::GetStyle();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    const ImGuiCol frame = active    ? ImGuiCol_FrameBgActive
                           : hovered ? ImGuiCol_FrameBgHovered
                                     : ImGuiCol_FrameBg;
    list->AddRectFilled(lower, upper, ImGui::GetColorU32(frame), style.FrameRounding);
    if (style.FrameBorderSize > 0.0f) {
        list->AddRect(lower, upper, ImGui::GetColorU32(ImGuiCol_Border), style.FrameRounding);
    }
    const float middle = track.left + track.width * static_cast<float>(std::clamp(share, 0.0, 1.0));
    list->AddRectFilled(
        {middle - track.grab / 2.0f, lower.y + kGrabMargin},
        {middle + track.grab / 2.0f, upper.y - kGrabMargin},
        ImGui::GetColorU32(active ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab),
        style.GrabRounding);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float left = std::max(lower.x + 2.0f, (lower.x + upper.x - size.x) / 2.0f);
    list->PushClipRect(lower, upper, true);
    list->AddText({left, lower.y + style.FramePadding.y}, ImGui::GetColorU32(ImGuiCol_Text),
                  text.c_str());
    list->PopClipRect();
}

}  // namespace

bool numberSlider(const char* id, double& value, const NumberRange& range, const std::string& text,
                  const std::string& unit) {
    ImGui::PushID(id);
    const ImGuiID own = ImGui::GetID("##slider");
    const bool stale = typing.frame + 1 < ImGui::GetFrameCount();
    bool changed = false;
    if (typing.id == own && !stale) {
        changed = typeIn(value, range, unit);
        ImGui::PopID();
        return changed;
    }
    const ImVec2 lower = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(1.0f, ImGui::CalcItemWidth()), ImGui::GetFrameHeight()};
    ImGui::InvisibleButton("##slider", size);
    const Track track = trackOf(lower, size.x);
    if (ImGui::IsItemActivated() && ImGui::GetIO().KeyCtrl) {
        typing = {own, text, "", false, ImGui::GetFrameCount()};
        if (!unit.empty() && typing.text.ends_with(unit)) {
            typing.text.resize(typing.text.size() - unit.size());
        }
    } else if (ImGui::IsItemActive() && typing.id != own) {
        changed = drag(value, range, track);
    }
    show(lower, {lower.x + size.x, lower.y + size.y}, shareOf(value, range), track, text);
    ImGui::PopID();
    return changed;
}

}  // namespace neph::ui
