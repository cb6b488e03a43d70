// sun_tools.cpp: which of date and place the data state, and where the sun is by them.
#include "app/ui/fields/sun_tools.h"

#include <imgui.h>

#include <string>

#include "app/ui/panel/action_button.h"
#include "app/ui/widgets/places.h"
#include "core/look/sun.h"

namespace neph::ui {
namespace {

void drawDate(const Session& session, const SunState& sun) {
    const auto line = [](const std::string& text) { ImGui::TextUnformatted(text.c_str()); };
    line(utcText(sun.utc) + (sun.dateOfData ? ", of the data" : ", by day and hour below"));
    place("sun.date_text");
    line(geoText(sun.place) + (sun.placeOfData ? ", of the data" : ", as set below"));
    place("sun.place_text");
    const DatasetInfo* info = session.info();
    if (!sun.placeOfData && info != nullptr && !info->noPlace.empty()) {
        ImGui::TextDisabled("%s", ("No place: " + info->noPlace).c_str());
    }
    ImGui::Text("Azimuth %.1f°, elevation %.1f°", static_cast<double>(sun.azimuthDeg),
                static_cast<double>(sun.elevationDeg));
}

}  // namespace

void drawSunTools(const PanelContext& context) {
    const Session& session = context.session();
    const SunState sun = sunStateOf(session.document.look, session.where());
    if (sun.byDate) drawDate(session, sun);
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2.0f * inner) / 3.0f;
    actionButton(context.actions, "sun.golden_hour", "Golden hour", third, false);
    actionButton(context.actions, "sun.noon", "Noon", third, false);
    actionButton(context.actions, "sun.backlit", "Backlit", third, true);
}

}  // namespace neph::ui
