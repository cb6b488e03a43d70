// action_button.cpp: drawn with what the action says of itself.
#include "app/ui/panel/action_button.h"

#include <imgui.h>

#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"

namespace neph::ui {

void actionButton(const ActionLookup& actions, const char* id, const char* label, float width,
                  bool last) {
    const ActionFace face = actions.face(id);
    ImGui::BeginDisabled(!face.enabled);
    if (ImGui::Button(label, {width, 0.0f})) actions.run(id);
    ImGui::EndDisabled();
    place(id);
    tooltip(face.tooltip);
    if (!last) ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
}

}  // namespace neph::ui
