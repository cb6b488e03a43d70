// input.cpp: tooltips of one width, which stand beside what they explain and wait for the mouse to
// move after a click.
#include "app/ui/widgets/input.h"

#include <imgui_internal.h>  // what has the keyboard next, the size of a tooltip

#include <algorithm>
#include <array>

namespace neph::ui {
namespace {

constexpr float kTooltipEms = 26.0f;
constexpr float kGapEms = 0.3f;  // between an item and its tooltip

glm::vec2 toGlm(ImVec2 v) {
    return {v.x, v.y};
}

ImGuiID numberField = 0;  // that the keyboard was in

/// From the press of a button until the mouse has moved on. There is one mouse.
struct AfterClick {
    const ImGuiContext* gui = nullptr;
    int frame = -1;  // of the last look
    bool quiet = false;
    glm::vec2 at{0.0f};
};

bool quietAfterClick() {
    static AfterClick click;
    const int frame = ImGui::GetFrameCount();
    if (click.gui != GImGui || frame < click.frame) click = {.gui = GImGui};
    if (click.frame == frame) return click.quiet;
    click.frame = frame;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 mouse = toGlm(io.MousePos);
    if (ImGui::IsAnyMouseDown()) {
        click.quiet = true;
        click.at = mouse;
    } else if (glm::distance(mouse, click.at) >= io.MouseDragThreshold) {
        click.quiet = false;
    }
    return click.quiet;
}

/// As it was laid out last.
glm::vec2 lastTooltipSize() {
    const ImGuiWindow* window = ImGui::FindWindowByName("##Tooltip_00");
    return window == nullptr ? glm::vec2(0.0f) : toGlm(window->Size);
}

glm::vec2 sizeOf(const std::string& text) {
    const ImVec2 words =
        ImGui::CalcTextSize(text.c_str(), nullptr, false, kTooltipEms * ImGui::GetFontSize());
    return toGlm(words) + 2.0f * toGlm(ImGui::GetStyle().WindowPadding);
}

void beginWrapped() {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * kTooltipEms);
}

}  // namespace

std::optional<glm::vec2> besideItem(const Area& item, glm::vec2 size, glm::vec2 window,
                                    glm::vec2 mouse, bool sideways) {
    const float gap = kGapEms * ImGui::GetFontSize();
    const glm::vec2 most = window - size;
    if (most.x < 0.0f || most.y < 0.0f) return {};
    // Along a long item it follows the mouse.
    const float along = std::clamp(mouse.x - size.x / 2.0f, item.lower.x,
                                   std::max(item.lower.x, item.upper.x - size.x));
    const float x = std::clamp(along, 0.0f, most.x);
    const float y = std::clamp(item.lower.y, 0.0f, most.y);
    const float below = item.upper.y + gap, above = item.lower.y - gap - size.y;
    const float right = item.upper.x + gap, left = item.lower.x - gap - size.x;
    std::array<std::optional<glm::vec2>, 4> places;
    if (below <= most.y) places[0] = {x, below};
    if (above >= 0.0f) places[1] = {x, above};
    if (right <= most.x) places[2] = {right, y};
    if (left >= 0.0f) places[3] = {left, y};
    if (sideways) std::rotate(places.begin(), places.begin() + 2, places.end());
    const auto found = std::ranges::find_if(places, [](const auto& at) { return at.has_value(); });
    return found == places.end() ? std::nullopt : *found;
}

Area lastItem() {
    return {toGlm(ImGui::GetItemRectMin()), toGlm(ImGui::GetItemRectMax())};
}

void nextTooltipBeside(const Area& item, std::optional<glm::vec2> size) {
    const ImGuiIO& io = ImGui::GetIO();
    // In a menu or a list what is above and below is wanted next.
    const bool sideways = (ImGui::GetCurrentWindow()->Flags & ImGuiWindowFlags_Popup) != 0;
    const auto at = besideItem(item, size.value_or(lastTooltipSize()), toGlm(io.DisplaySize),
                               toGlm(io.MousePos), sideways);
    if (at) ImGui::SetNextWindowPos({at->x, at->y});
}

bool wantsTooltip() {
    const bool quiet = quietAfterClick();  // looks at the mouse in every frame
    return ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !quiet;
}

void tooltip(const std::string& text) {
    if (!wantsTooltip()) return;
    nextTooltipBeside(lastItem(), sizeOf(text));
    beginWrapped();
    ImGui::TextUnformatted(text.c_str());
    endTooltip();
}

bool beginTooltip() {
    if (!wantsTooltip()) return false;
    nextTooltipBeside(lastItem());
    beginWrapped();
    return true;
}

void endTooltip() {
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

std::string shortened(const std::string& text, float width) {
    const auto widthOf = [](const std::string& s) { return ImGui::CalcTextSize(s.c_str()).x; };
    if (widthOf(text) <= width) return text;
    std::string shown = text;
    while (!shown.empty() && widthOf(shown + "..") > width) {
        while (shown.size() > 1 && (static_cast<unsigned char>(shown.back()) & 0xC0U) == 0x80U) {
            shown.pop_back();  // the bytes of a letter that follow its first
        }
        shown.pop_back();
    }
    return shown + "..";
}

void takeDecimalCommas() {
    const ImGuiID active = GImGui->ActiveId;
    // A slider that is typed into, or a field that said so in the last frame.
    if (active == 0 || (active != GImGui->TempInputId && active != numberField)) return;
    for (ImWchar& letter : ImGui::GetIO().InputQueueCharacters) {
        if (letter == ',') letter = '.';
    }
}

void noteNumberField() {
    if (ImGui::IsItemActive()) numberField = GImGui->ActiveId;
}

bool inputUnsettled() {
    const ImGuiContext& gui = *GImGui;
    return gui.NavMoveSubmitted || gui.NavNextActivateId != 0 ||
           (gui.WantTextInputNextFrame == 1) != gui.IO.WantTextInput;
}

}  // namespace neph::ui
