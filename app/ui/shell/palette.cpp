// palette.cpp: a line to type in and what it finds; arrows choose, Enter runs, Escape closes.
#include "app/ui/shell/palette.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/ui/shell/command_search.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"

namespace neph::ui {
namespace {

constexpr float kPaletteEms = 34.0f;
constexpr int kRows = 14;
constexpr std::size_t kMostRecent = 8;
constexpr const char* kName = "##palette";

bool canRun(const Command& command, const Ui& ui) {
    return command.action == nullptr || isEnabled(*command.action, ui);
}

void remember(std::vector<std::string>& recent, std::string_view id) {
    std::erase(recent, id);
    recent.insert(recent.begin(), std::string(id));
    if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

/// An action does what it says; a parameter is shown, ready to be changed.
void run(Ui& ui, const Command& command) {
    remember(ui.palette.recent, command.id());
    ImGui::CloseCurrentPopup();
    if (command.action != nullptr) return command.action->run(ui);
    ui.columns.shown = true;
    openColumn(ui.settings, ui.columns, false, true);
    ui.fields.find = command.parameter->id;
}

/// Chord of an action, value of a parameter.
std::string noteOf(const Ui& ui, const Command& command) {
    if (command.action != nullptr) return chordText(command.action->chord);
    const Parameter& row = *command.parameter;
    return screenText(row, valueOf(ui.session().document, row));
}

std::string helpOf(const Command& command, const Ui& ui) {
    return command.action != nullptr ? helpOf(*command.action, ui) : command.parameter->help;
}

void parameterMenu(Ui& ui, const Command& command) {
    if (command.parameter == nullptr || !ImGui::BeginPopupContextItem("##menu")) return;
    Document& document = ui.session().document;
    const Parameter& row = *command.parameter;
    if (ImGui::MenuItem("Reset to default")) setValue(document, row, defaultOf(row));
    if (ImGui::MenuItem("Copy id=value")) {
        ImGui::SetClipboardText((row.id + "=" + formatValue(row, valueOf(document, row))).c_str());
    }
    ImGui::EndPopup();
}

/// True when it was clicked.
bool drawRow(Ui& ui, const Command& command, bool chosen) {
    const float start = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
    const std::string id(command.id());
    ImGui::PushID(id.c_str());
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const auto flags =
        canRun(command, ui) ? ImGuiSelectableFlags_DontClosePopups : ImGuiSelectableFlags_Disabled;
    const bool clicked = ImGui::Selectable(command.label().c_str(), chosen, flags);
    ImGui::PopStyleColor();
    place("palette:" + id);
    tooltip(helpOf(command, ui));
    parameterMenu(ui, command);
    const std::string note = noteOf(ui, command), where = command.where();
    const float noteAt = start + width - ImGui::CalcTextSize(note.c_str()).x;
    const float whereAt = start + 0.56f * width;
    if (whereAt > start + ImGui::CalcTextSize(command.label().c_str()).x + ImGui::GetFontSize()) {
        ImGui::SameLine(whereAt);
        ImGui::TextDisabled("%s", where.c_str());
    }
    ImGui::SameLine(noteAt);
    ImGui::TextUnformatted(note.c_str());
    ImGui::PopID();
    return clicked;
}

/// The row that the arrows lead to; its list must follow it.
bool moveChosen(int& chosen, int count) {
    const int before = chosen;
    if (pressed(ImGuiKey_DownArrow)) ++chosen;
    if (pressed(ImGuiKey_UpArrow)) --chosen;
    if (pressed(ImGuiKey_PageDown)) chosen += kRows;
    if (pressed(ImGuiKey_PageUp)) chosen -= kRows;
    chosen = std::clamp(chosen, 0, std::max(0, count - 1));
    return chosen != before;
}

void drawList(Ui& ui, bool entered) {
    const std::vector<Command> found = findCommands(ui.palette.text, ui.palette.recent);
    const bool moved = moveChosen(ui.palette.chosen, static_cast<int>(found.size()));
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const float room = 0.7f * ImGui::GetIO().DisplaySize.y;
    if (ImGui::BeginChild("##found", {0.0f, std::min(kRows * row, room)})) {
        if (found.empty()) ImGui::TextDisabled("No command or parameter matches");
        for (int i = 0; i < static_cast<int>(found.size()); ++i) {
            const Command& command = found[static_cast<std::size_t>(i)];
            const bool chosen = i == ui.palette.chosen;
            const bool clicked = drawRow(ui, command, chosen);
            if (chosen && moved) ImGui::SetScrollHereY();
            if ((clicked || (entered && chosen)) && canRun(command, ui)) {
                ui.palette.chosen = 0;
                ImGui::EndChild();
                return run(ui, command);
            }
        }
    }
    ImGui::EndChild();
}

}  // namespace

void drawPalette(Ui& ui) {
    const float em = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const bool opens = std::exchange(ui.palette.open, false);
    if (opens) {
        ui.palette.text.clear();
        ui.palette.chosen = 0;
        ImGui::OpenPopup(kName);
    }
    ImGui::SetNextWindowPos({display.x / 2.0f, 0.12f * display.y}, ImGuiCond_Always, {0.5f, 0.0f});
    ImGui::SetNextWindowSize({std::min(kPaletteEms * em, display.x - 2.0f * em), 0.0f});
    if (!ImGui::BeginPopup(kName)) return;
    if (opens) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    const std::string before = ui.palette.text;
    const bool entered =
        ImGui::InputTextWithHint("##text", "Part of a command's or a parameter's name",
                                 &ui.palette.text, ImGuiInputTextFlags_EnterReturnsTrue);
    place("palette.text");
    if (ui.palette.text != before) ui.palette.chosen = 0;
    // What is typed goes to the line wherever the mouse has been.
    if (!opens && !entered && !ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(0)) {
        ImGui::SetKeyboardFocusHere(-1);
    }
    ImGui::Separator();
    drawList(ui, entered);
    if (pressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace neph::ui
