// path_popup.cpp: a line to type a path in, where nothing can be dropped on the window.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>

#include "app/ui/panels.h"

namespace neph::ui {

void drawPathPopup(Ui& ui) {
    if (ui.askForPath) ImGui::OpenPopup("Open");
    if (!ImGui::BeginPopupModal("Open", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
    ImGui::TextUnformatted("A file of model output, or a folder with the files of one series");
    if (ui.askForPath) ImGui::SetKeyboardFocusHere();
    ui.askForPath = false;
    ImGui::SetNextItemWidth(36.0f * ImGui::GetFontSize());
    const bool entered = ImGui::InputText("##path", &ui.path, ImGuiInputTextFlags_EnterReturnsTrue);
    if ((ImGui::Button("Open") || entered) && !ui.path.empty()) {
        ui.session().open(std::array{ui.path});
        ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine();
    if (ImGui::Button("Cancel")) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace neph::ui
