// camera_drag.cpp: the camera under the mouse, and in flight.
//
// Left drag orbits, middle drag or Shift with left drag pans, right drag moves nearer and farther,
// the wheel zooms to the cursor. In flight, or with the right button held, W A S D move the eye, E
// and Q lift and lower it, and a drag looks around. Rates are shares of the image's height, tuned
// by eye.
#include "app/ui/camera/camera_drag.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/camera/camera_view.h"

namespace neph::ui {
namespace {

constexpr float kOrbitDegPerHeight = 180.0f;
constexpr float kLookPerHeight = 1.0f;   // images: what is under the user goes with it
constexpr float kDollyPerHeight = 3.0f;  // e-foldings
constexpr float kDollyPerNotch = 0.9f;   // factor of the distance for one notch of the wheel
constexpr double kFaster = 4.0;          // with Shift
constexpr double kSpeedPerNotch = 1.25;
constexpr double kLeastSpeed = 1e-4, kMostSpeed = 1.0;  // extents per second
constexpr double kFirstFrameS = 1.0 / 60.0, kLongestFrameS = 0.1;

/// A drag belongs to the image when it began on the image.
bool dragging(ImGuiMouseButton button) {
    return ImGui::IsMouseDown(button) && !ImGui::GetIO().WantCaptureMouse &&
           !ImGui::IsAnyItemActive();
}

/// Of a letter, where an American keyboard has it: the window system's codes are its capitals.
/// Places matter for flight, not what is printed on them.
float held(char capital) {
    return ImGui::GetIO().KeysDown[static_cast<int>(capital)] ? 1.0f : 0.0f;
}

/// Right, up and forwards; zero while keys are meant for something else.
glm::vec3 flightKeys() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || io.KeyCtrl || io.KeyAlt || io.KeySuper) return glm::vec3(0.0f);
    return {held('D') - held('A'), held('E') - held('Q'), held('W') - held('S')};
}

/// Where the mouse is in the image, in [-1, 1], y up.
glm::dvec2 cursorNdc(const Area& image) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::vec2 share = (glm::vec2(mouse.x, mouse.y) - image.lower) / image.size();
    return glm::clamp(glm::dvec2(2.0f * share.x - 1.0f, 1.0f - 2.0f * share.y), -1.0, 1.0);
}

void moveByKeys(const PanelContext& context, CameraTools& tools, const RegularGrid& grid) {
    const glm::vec3 keys = flightKeys();
    const bool moves = (tools.flying || tools.fliesHeld) && keys != glm::vec3(0.0f);
    if (moves) {
        // After a pause the last frame is long ago.
        const double seconds = std::min(static_cast<double>(ImGui::GetIO().DeltaTime),
                                        tools.moves ? kLongestFrameS : kFirstFrameS);
        const double extentM = std::max(grid.extentM().x, grid.extentM().y);
        const double stepM =
            tools.flySpeed * extentM * seconds * (ImGui::GetIO().KeyShift ? kFaster : 1.0);
        tools.outOfReach = !fly(context.session().document.camera, grid, glm::dvec3(keys) * stepM);
        context.next.animates = true;
    }
    tools.moves = moves;
}

/// Shares of the image's height that the mouse has moved.
void moveByDrag(CameraPose& pose, const CameraTools& tools, const RegularGrid& grid, float dx,
                float dy) {
    const bool left = dragging(ImGuiMouseButton_Left) && !tools.sun.given && !tools.leftTaken,
               right = dragging(ImGuiMouseButton_Right);
    if (dragging(ImGuiMouseButton_Middle) || (left && ImGui::GetIO().KeyShift && !tools.flying)) {
        pan(pose, grid, {dx, -dy});
    } else if ((tools.flying && (left || right)) || (tools.fliesHeld && right)) {
        const float deg = kLookPerHeight * pose.fovDeg;
        lookAround(pose, grid, -dx * deg, dy * deg);
    } else if (left) {
        orbit(pose, dx * kOrbitDegPerHeight, dy * kOrbitDegPerHeight);
    } else if (right) {
        dolly(pose, std::exp(dy * kDollyPerHeight));
    }
}

void moveByWheel(const PanelContext& context, CameraTools& tools, const RegularGrid& grid,
                 float notches) {
    if (tools.flying || tools.fliesHeld) {
        tools.flySpeed =
            std::clamp(tools.flySpeed * std::pow(kSpeedPerNotch, static_cast<double>(notches)),
                       kLeastSpeed, kMostSpeed);
    } else {
        const Layout layout = context.layout();
        zoomTo(context.session().document.camera, grid, cursorNdc(layout.image), aspectOf(layout),
               std::pow(kDollyPerNotch, notches));
    }
}

}  // namespace

void moveCamera(const PanelContext& context, CameraTools& tools) {
    const ImGuiIO& io = ImGui::GetIO();
    const RegularGrid grid = gridOf(context.session());
    dragSun(context, tools.sun, !tools.flying);
    const bool right = dragging(ImGuiMouseButton_Right);
    tools.fliesHeld = right && (tools.fliesHeld || flightKeys() != glm::vec3(0.0f));
    moveByKeys(context, tools, grid);
    const float height =
        static_cast<float>(imageBox(context.layout()).size().y) / io.DisplayFramebufferScale.y;
    if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f) {
        moveByDrag(context.session().document.camera, tools, grid, io.MouseDelta.x / height,
                   io.MouseDelta.y / height);
    }
    if (io.MouseWheel != 0.0f && !io.WantCaptureMouse)
        moveByWheel(context, tools, grid, io.MouseWheel);
}

}  // namespace neph::ui
