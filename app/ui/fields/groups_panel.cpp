// groups_panel.cpp: every parameter that is not of a field, a fold per group, and a box
// that finds any parameter.
#include "app/ui/fields/groups_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/ui/fields/fields_link.h"
#include "app/ui/fields/sun_tools.h"
#include "app/ui/widgets/parameter_widget.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/words.h"
#include "core/look/exposure.h"
#include "core/look/haze.h"

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

void drawFound(Session& session, const FieldsState& state) {
    Look& look = session.document.look;
    std::string group;
    ImGui::PushID("found");
    for (const Parameter& row : parameterTable()) {
        if (!matches(row, state.find) || !applies(row, look)) continue;
        if (row.group != group) {
            group = row.group;
            ImGui::TextDisabled("%s", group.c_str());
        }
        const Look before = look;
        parameterWidget(row, session.document, session.presetLook);
        if (row.species && linkOf(state, *row.species)) {
            follow(look, before, state.atPress, *row.species);
        }
    }
    ImGui::PopID();
    if (group.empty()) ImGui::TextDisabled("No parameter matches");
    ImGui::Separator();
}

/// What the camera of such a photograph would be set to.
void drawExposure(const Session& session) {
    const Look look = lookAsDrawn(session.document.look, session.where());
    if (look.toneMap == ToneMap::reflectance) return;
    ImGui::TextDisabled("EV100 %.1f", exposureValue(look));
    place("view.ev100_text");
}

/// How far one sees, where that follows from the data.
void drawHaze(const Session& session) {
    const Look& look = session.document.look;
    if (!asksHumidity(look)) return;
    const HazeState haze = hazeOf(look, session.where());
    if (haze.humidity) {
        const char* by = haze.byAerosol               ? ", by aerosol"
                         : look.haze == Haze::aerosol ? ", no aerosol in the data"
                                                      : "";
        ImGui::TextDisabled("%.3g km, relative humidity %.0f %%%s", 1e-3 * haze.visibilityM,
                            100.0 * *haze.humidity, by);
    } else {
        ImGui::TextDisabled("No humidity in the data: visibility as set");
    }
    place("sky.haze_text");
}

}  // namespace

void drawFind(const PanelContext& context, FieldsState& state) {
    if (!ImGui::IsAnyItemActive()) state.atPress = context.session().document.look;
    const float clear = ImGui::GetFrameHeight();
    const bool typed = !state.find.empty();
    ImGui::SetNextItemWidth(typed ? -clear - ImGui::GetStyle().ItemSpacing.x : -1.0f);
    ImGui::InputTextWithHint("##find", "Find a parameter", &state.find);
    place("find");
    if (typed) {
        ImGui::SameLine();
        if (ImGui::Button("x##clear", {clear, 0.0f})) state.find.clear();
        place("find.clear");
    }
    const bool wanted = state.find.find_first_not_of(' ') != std::string::npos;
    if (wanted) drawFound(context.session(), state);
}

void drawGroups(const PanelContext& context) {
    Session& session = context.session();
    std::string group;
    bool open = false;
    for (const Parameter& row : parameterTable()) {
        if (row.species || !applies(row, session.document.look)) continue;
        if (row.group != group) {
            group = row.group;
            open = beginGroup(group);
            if (open && row.id == "sun.source") drawSunTools(context);
        }
        if (open) parameterWidget(row, session.document, session.presetLook);
        if (open && row.id == "view.exposure") drawExposure(session);
        if (open && row.id == "sky.haze") drawHaze(session);
    }
}

}  // namespace neph::ui
