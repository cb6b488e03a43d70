// fields_depth.cpp: one number per field: how much light it takes away along the middle of the
// view.
#include <imgui.h>

#include "app/ui/fields/fields_plots.h"
#include "app/ui/widgets/input.h"
#include "core/base/number_text.h"

namespace neph::ui {

const std::optional<OpticalDepth>& probeDepth(FieldsState& state, const Session& session) {
    DepthProbe& probe = state.probe;
    const std::shared_ptr<const HeldVolume>& held = session.held();
    if (!held) {
        probe = {};
        return probe.depth;
    }
    const Document& document = session.document;
    const bool same = probe.depth && probe.volume.lock() == held && probe.pose == document.camera &&
                      probe.look == document.look;
    if (same) return probe.depth;
    const Camera camera = placeCamera(document.camera, held->volume->grid, 1.0);
    const MediumPlan plan =
        planMedium(document.look, held->volume->holdings(), held->volume->cellM());
    probe = {held, document.camera, document.look,
             opticalDepthAlong(*held->volume, plan, camera.eyeWorld, camera.forward)};
    return probe.depth;
}

void drawDepth(FieldsState& state, const Session& session, Species species) {
    const std::optional<OpticalDepth>& depth = probeDepth(state, session);
    if (!depth) return;
    const double own = depth->of[static_cast<std::size_t>(species)];
    ImGui::TextDisabled("Optical depth");
    ImGui::SameLine();
    ImGui::Text("%s", numberText(own, 3).c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("of %s", numberText(depth->total(), 3).c_str());
    tooltip(
        "Along the ray through the middle of the image: this field, and all visible ones, with "
        "the look's radii, densities and mixing scales (Eq. 9) and without detail noise. At an "
        "optical depth of 1, 37 % of the light comes straight through.");
}

}  // namespace neph::ui
