// camera_drag.cpp: the camera under the mouse.
//
// As in F3D: left drag orbits, middle drag or shift with left drag pans, right drag and wheel move
// nearer and farther. Rates are shares of the picture's height, tuned by eye.
#include <imgui.h>

#include <cmath>

#include "app/ui/panels.h"
#include "core/camera.h"

namespace neph::ui {
namespace {

constexpr float kOrbitDegPerHeight = 180.0f;
constexpr float kDollyPerHeight = 3.0f;  // e-foldings
constexpr float kDollyPerNotch = 0.9f;   // factor of the distance for one notch of the wheel

/// Until data are there the camera moves in a cube.
RegularGrid gridOf(const Session& session) {
    if (session.shown()) return session.shown()->grid;
    return {{1, 1, 1}, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
}

/// A drag belongs to the picture when it began on the picture.
bool dragging(ImGuiMouseButton button) {
    return ImGui::IsMouseDown(button) && !ImGui::GetIO().WantCaptureMouse &&
           !ImGui::IsAnyItemActive();
}

}  // namespace

void moveCamera(Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    CameraPose& pose = ui.session().document.camera;
    const float height = static_cast<float>(pictureBox(ui).size().y) / io.DisplayFramebufferScale.y;
    const float dx = io.MouseDelta.x / height, dy = io.MouseDelta.y / height;
    const bool left = dragging(ImGuiMouseButton_Left);
    const bool moved = dx != 0.0f || dy != 0.0f;
    if (moved && (dragging(ImGuiMouseButton_Middle) || (left && io.KeyShift))) {
        pan(pose, gridOf(ui.session()), {dx, -dy});
    } else if (moved && left) {
        orbit(pose, dx * kOrbitDegPerHeight, dy * kOrbitDegPerHeight);
    } else if (moved && dragging(ImGuiMouseButton_Right)) {
        dolly(pose, std::exp(dy * kDollyPerHeight));
    }
    if (io.MouseWheel != 0.0f && !io.WantCaptureMouse) {
        dolly(pose, std::pow(kDollyPerNotch, io.MouseWheel));
    }
}

}  // namespace neph::ui
