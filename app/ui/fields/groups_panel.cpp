// groups_panel.cpp: every parameter that is not of a field, a fold per group, and a box
// that finds any parameter.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/ui/fields/fields_link.h"
#include "app/ui/shell/panels.h"
#include "app/ui/widgets/parameter_widget.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/words.h"

namespace neph::ui {
namespace {

bool beginGroup(const std::string& group) {
    // What is tuned most stands open.
    const bool open = group == "Modes" || group == "Sun and sky";
    const bool shown =
        ImGui::CollapsingHeader(group.c_str(), open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    place("group:" + group);
    return shown;
}

bool matches(const Parameter& row, const std::string& wanted) {
    return holdsWords(
        row.group + " " + row.label + " " + row.id + " " + row.help + " " + row.displayUnit,
        wanted);
}

void drawFound(Ui& ui, const std::string& wanted) {
    Session& session = ui.session();
    Look& look = session.document.look;
    std::string group;
    ImGui::PushID("found");
    for (const Parameter& row : parameterTable()) {
        if (!matches(row, wanted) || !applies(row, look)) continue;
        if (row.group != group) {
            group = row.group;
            ImGui::TextDisabled("%s", group.c_str());
        }
        const Look before = look;
        parameterWidget(row, session.document, session.presetLook);
        if (row.species && linkOf(ui.fields, *row.species)) {
            follow(look, before, ui.fields.atPress, *row.species);
        }
    }
    ImGui::PopID();
    if (group.empty()) ImGui::TextDisabled("No parameter has that in its name or help");
    ImGui::Separator();
}

}  // namespace

void drawFind(Ui& ui) {
    if (!ImGui::IsAnyItemActive()) ui.fields.atPress = ui.session().document.look;
    const float clear = ImGui::GetFrameHeight();
    const bool typed = !ui.fields.find.empty();
    ImGui::SetNextItemWidth(typed ? -clear - ImGui::GetStyle().ItemSpacing.x : -1.0f);
    ImGui::InputTextWithHint("##find", "Find a parameter", &ui.fields.find);
    place("find");
    if (typed) {
        ImGui::SameLine();
        if (ImGui::Button("x##clear", {clear, 0.0f})) ui.fields.find.clear();
        place("find.clear");
    }
    const std::string& wanted = ui.fields.find;
    if (wanted.find_first_not_of(' ') != std::string::npos) drawFound(ui, wanted);
}

void drawGroups(Ui& ui) {
    Session& session = ui.session();
    std::string group;
    bool open = false;
    for (const Parameter& row : parameterTable()) {
        if (row.species || !applies(row, session.document.look)) continue;
        if (row.group != group) {
            group = row.group;
            open = beginGroup(group);
        }
        if (open) parameterWidget(row, session.document, session.presetLook);
    }
}

}  // namespace neph::ui
