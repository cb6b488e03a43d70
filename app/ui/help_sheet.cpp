// help_sheet.cpp: what mouse and keys do.
#include <imgui.h>

#include <array>
#include <utility>

#include "app/ui/actions.h"
#include "app/ui/panels.h"

namespace neph::ui {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 7> kMouse{{
    {"Left drag", "Orbit"},
    {"Middle drag, Shift+left", "Pan"},
    {"Wheel, right drag", "Nearer, farther"},
    {"Ctrl+click a slider", "Type a value"},
    {"Double click a label", "Reset to default"},
    {"Right click a parameter", "Reset, copy its id"},
    {"Drop on the window", "Model output, or a preset"},
}};

void line(const char* what, const char* does) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", what);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(does);
}

}  // namespace

void drawHelp(Ui& ui) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2.0f, display.y / 2.0f}, ImGuiCond_Always, {0.5f, 0.5f});
    const auto flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;
    if (ImGui::Begin("Mouse and keys", &ui.showHelp, flags) && ImGui::BeginTable("##help", 2)) {
        for (const auto& [what, does] : kMouse) line(what, does);
        for (const Action& action : actions()) {
            if (action.chord.key == Key::none) continue;
            line(chordText(action.chord).c_str(), std::string(action.label).c_str());
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace neph::ui
