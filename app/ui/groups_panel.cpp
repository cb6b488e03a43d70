// groups_panel.cpp: everything in the look table that is not of a field, a fold a group.
#include <imgui.h>

#include "app/ui/panels.h"
#include "app/ui/parameter_widget.h"

namespace neph::ui {
namespace {

bool beginGroup(const std::string& group) {
    // What is tuned most stands open.
    const bool open = group == "Modes" || group == "Sun and sky";
    return ImGui::CollapsingHeader(group.c_str(), open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

}  // namespace

void drawGroups(Ui& ui) {
    Look& look = ui.session().document.look;
    std::string group;
    bool open = false;
    for (const Parameter& row : lookTable()) {
        if (row.species) continue;
        if (row.group != group) {
            group = row.group;
            open = beginGroup(group);
        }
        if (open && applies(row, look)) parameterWidget(row, look);
    }
}

}  // namespace neph::ui
