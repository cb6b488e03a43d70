// help_sheet.cpp: what mouse and keys do, in as many columns as the window has room for.
#include "app/ui/shell/help_sheet.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/ui/shell/actions.h"
#include "app/ui/widgets/places.h"

namespace neph::ui {
namespace {

constexpr float kColumnEms = 18.0f, kKeyEms = 7.6f;
constexpr int kMostColumns = 4;

struct Line {
    std::string what;  ///< mouse or key; empty: a heading
    std::string does;
};
using Section = std::vector<Line>;

Section mouse() {
    return {{"", "Mouse"},
            {"Left drag", "Orbit"},
            {"Middle, Shift+drag", "Pan"},
            {"Wheel", "Towards the cursor, or away"},
            {"Right drag", "Nearer, farther"},
            {"Drag of the sun", "Moves it, not the camera"},
            {"W A S D E Q", "Fly (G, or right button)"},
            {"Ctrl+click a slider", "Type a value"},
            {"Shift+drag a slider", "Fine adjustment"},
            {"Double click a label", "Back to the preset"},
            {"Right click", "Reset, copy, paste"},
            {"Drop a file", "Open data or a preset"}};
}

std::string chordsOf(const Action& action) {
    const std::string other = chordText(action.other);
    return chordText(action.chord) + (other.empty() ? "" : ", " + other);
}

std::vector<Section> sections() {
    std::vector<Section> all{mouse()};
    for (int i = 0; i < kMenuCount; ++i) {
        const auto menu = static_cast<Menu>(i);
        Section section{{"", std::string(menuName(menu))}};
        for (const Action& action : actions()) {
            if (action.menu != menu || action.chord.key == Key::none) continue;
            section.push_back({chordsOf(action), std::string(action.label)});
        }
        if (section.size() > 1) all.push_back(std::move(section));
    }
    return all;
}

void drawLine(const Line& line) {
    if (line.what.empty()) {
        ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", line.does.c_str());
        return;
    }
    const float start = ImGui::GetCursorScreenPos().x;
    ImGui::TextDisabled("%s", line.what.c_str());
    const float after = ImGui::GetItemRectMax().x - start + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SameLine(std::max(kKeyEms * ImGui::GetFontSize(), after));
    ImGui::TextUnformatted(line.does.c_str());
}

/// For each section the column that it stands in, where a column has room for `full` lines.
std::vector<int> columnsOf(const std::vector<Section>& all, std::size_t full) {
    std::vector<int> columns;
    std::size_t used = 0;
    int column = 0;
    for (const Section& section : all) {
        if (used > 0 && used + section.size() > full) {
            ++column;
            used = 0;
        }
        used += section.size();
        columns.push_back(column);
    }
    return columns;
}

/// Lines of the tallest of as many columns as short as they can be.
std::size_t linesOf(const std::vector<Section>& all, int columns) {
    std::size_t full = 1;
    while (columnsOf(all, full).back() >= columns) ++full;
    return full;
}

/// Letters are smaller where the sheet would not fit.
float scaleFor(const std::vector<Section>& all, int columns, float heightPx) {
    constexpr float kLeast = 0.7f, kAround = 5.0f;  // lines of title, padding and gaps
    const float lines = static_cast<float>(linesOf(all, columns)) + kAround;
    const float whole = ImGui::GetTextLineHeight();
    // Whole pixels, as windows have them.
    return std::floor(whole * std::clamp(heightPx / (lines * whole), kLeast, 1.0f)) / whole;
}

/// Sections one below the other.
void drawSections(const std::vector<Section>& all, int columns) {
    const std::size_t full = linesOf(all, columns);
    const std::vector<int> placed = columnsOf(all, full);
    const float width = kColumnEms * ImGui::GetFontSize();
    const float left = ImGui::GetCursorPosX();
    // Close together: the whole of it at a glance.
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.0f});
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i > 0 && placed[i] != placed[i - 1]) {
            ImGui::EndGroup();
            ImGui::SameLine(left + static_cast<float>(placed[i]) * width);
            ImGui::BeginGroup();
        }
        for (const Line& line : all[i]) drawLine(line);
        ImGui::Dummy({width - ImGui::GetFontSize(), std::floor(0.3f * ImGui::GetTextLineHeight())});
    }
    ImGui::EndGroup();
    ImGui::PopStyleVar();
}

}  // namespace

void drawHelp(bool& shown) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    const ImVec2 room{display.x - em, display.y - em};
    const int columns = std::clamp(static_cast<int>(room.x / (kColumnEms * em)), 1, kMostColumns);
    ImGui::SetNextWindowPos({display.x / 2.0f, display.y / 2.0f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, room);
    const auto flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;
    const std::vector<Section> all = sections();
    const float scale = scaleFor(all, columns, room.y);
    if (ImGui::Begin("Mouse and keys", &shown, flags)) {
        ImGui::SetWindowFontScale(scale);
        drawSections(all, columns);
    }
    ImGui::End();
}

}  // namespace neph::ui
