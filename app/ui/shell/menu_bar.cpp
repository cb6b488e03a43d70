// menu_bar.cpp: the table of actions as menus.
#include "app/ui/shell/menu_bar.h"

#include <imgui.h>

#include <string>

#include "app/ui/shell/actions.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"

namespace neph::ui {
namespace {

void drawItem(Ui& ui, const Action& action) {
    if (action.separated) ImGui::Separator();
    if (ImGui::MenuItem(std::string(action.label).c_str(), chordText(action.chord).c_str(),
                        isChecked(action, ui), isEnabled(action, ui))) {
        action.run(ui);
    }
    place(action.id);
    tooltip(helpOf(action, ui));
}

void drawMenus(Ui& ui) {
    for (int i = 0; i < kMenuCount; ++i) {
        const auto menu = static_cast<Menu>(i);
        const std::string name(menuName(menu));
        const bool open = ImGui::BeginMenu(name.c_str());
        place("menu:" + name);
        if (!open) continue;
        for (const Action& action : actions()) {
            if (action.menu == menu) drawItem(ui, action);
        }
        ImGui::EndMenu();
    }
}

/// Of the menus side by side.
float widthOfMenus() {
    float width = 2.0f * ImGui::GetStyle().FramePadding.x;
    for (int i = 0; i < kMenuCount; ++i) {
        const std::string name(menuName(static_cast<Menu>(i)));
        width += ImGui::CalcTextSize(name.c_str()).x + 2.0f * ImGui::GetStyle().ItemSpacing.x;
    }
    return width;
}

}  // namespace

void drawMenuBar(Ui& ui) {
    if (!ImGui::BeginMainMenuBar()) return;
    if (widthOfMenus() <= ImGui::GetIO().DisplaySize.x) {
        drawMenus(ui);
    } else if (ImGui::BeginMenu("Menu")) {
        drawMenus(ui);
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
}

}  // namespace neph::ui
