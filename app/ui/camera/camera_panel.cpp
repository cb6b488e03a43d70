// camera_panel.cpp: the camera in numbers, round its target and as an observer's, and the ways to
// set it at once.
#include "app/ui/camera/camera_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/camera/camera_lists.h"
#include "app/ui/camera/camera_view.h"
#include "app/ui/panel/action_button.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/number_slider.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"

namespace neph::ui {
namespace {

constexpr float kLabelShare = 0.42f;  // of the line, as for parameters
constexpr double kMPerKm = 1e3;
constexpr double kMostElevationDeg = 89.9;  // orbit() goes no further

struct NumberRow {
    const char* id;
    const char* label;
    NumberRange range;
    const char* unit;
    int digits;  ///< behind the point
    const char* help;
};

bool numberRow(const NumberRow& row, double& value) {
    const float line = ImGui::GetContentRegionAvail().x;
    const float start = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row.label);
    tooltip(row.help);
    ImGui::SameLine(start + line * kLabelShare);
    ImGui::SetNextItemWidth(-1.0f);
    double shown = value + 0.0;  // no "-0"
    if (std::abs(shown) < 0.5 * std::pow(10.0, -row.digits)) shown = 0.0;
    const bool changed = numberSlider(
        row.id, value, row.range, fmt::format("{:.{}f}{}", shown, row.digits, row.unit), row.unit);
    place(row.id);
    return changed;
}

bool degreesRow(const char* id, const char* label, double lo, double hi, const char* help,
                float& value) {
    auto shown = static_cast<double>(value);
    if (!numberRow({id, label, {lo, hi}, "°", 1, help}, shown)) return false;
    value = static_cast<float>(shown);
    return true;
}

void drawViews(const ActionLookup& actions) {
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const float line = ImGui::GetContentRegionAvail().x;
    const float third = (line - 2.0f * inner) / 3.0f, sixth = (line - 5.0f * inner) / 6.0f;
    actionButton(actions, "camera.fit", "Fit", third, false);
    actionButton(actions, "camera.observer", "Ground", third, false);
    actionButton(actions, "camera.home", "Preset's", third, true);
    actionButton(actions, "camera.north", "N", sixth, false);
    actionButton(actions, "camera.east", "E", sixth, false);
    actionButton(actions, "camera.south", "S", sixth, false);
    actionButton(actions, "camera.west", "W", sixth, false);
    actionButton(actions, "camera.plan", "Plan", sixth, false);
    actionButton(actions, "camera.below", "Up", sixth, true);
}

void drawPose(CameraPose& pose, const RegularGrid& grid) {
    degreesRow("camera.azimuth", "Azimuth", 0.0, 360.0,
               "Where the eye stands, seen from the target: 0 north, 90 east", pose.azimuthDeg);
    degreesRow("camera.elevation", "Elevation", -kMostElevationDeg, kMostElevationDeg,
               "Of the eye above the target's horizon", pose.elevationDeg);
    const double unitKm = std::max(grid.extentM().x, grid.extentM().y) / kMPerKm;
    double distanceKm = static_cast<double>(pose.distance) * unitKm;
    const NumberRange range{static_cast<double>(kMinDistance) * unitKm,
                            static_cast<double>(kMaxDistance) * unitKm, true};
    if (numberRow({"camera.distance", "Distance", range, " km", distanceKm < 10.0 ? 2 : 1,
                   "Distance from the eye to the target"},
                  distanceKm)) {
        pose.distance =
            std::clamp(static_cast<float>(distanceKm / unitKm), kMinDistance, kMaxDistance);
    }
    degreesRow("camera.fov", "Field of view", static_cast<double>(kMinFovDeg),
               static_cast<double>(kMaxFovDeg),
               "Vertical, from the image's lower edge to its upper", pose.fovDeg);
}

/// The same camera told by its eye. What is set here keeps the eye where it is, or the view.
void drawObserver(CameraPose& pose, CameraTools& tools, const RegularGrid& grid) {
    const bool open = ImGui::TreeNodeEx("Observer", ImGuiTreeNodeFlags_SpanAvailWidth);
    place("camera.observer_fold");
    if (!open) return;
    Observer observer = observerOf(pose, grid);
    const glm::dvec3 lower = (grid.originM - grid.extentM()) / kMPerKm;
    const glm::dvec3 upper = (grid.upperM() + grid.extentM()) / kMPerKm;
    double eastKm = observer.eastM / kMPerKm, northKm = observer.northM / kMPerKm;
    bool changed = numberRow({"observer.east",
                              "East",
                              {lower.x, upper.x},
                              " km",
                              2,
                              "Of the eye, from the domain's south-west corner"},
                             eastKm);
    changed |= numberRow({"observer.north",
                          "North",
                          {lower.y, upper.y},
                          " km",
                          2,
                          "Of the eye, from the domain's south-west corner"},
                         northKm);
    changed |= numberRow({"observer.height",
                          "Height",
                          {0.0, upper.z * kMPerKm, true},
                          " m",
                          std::abs(observer.heightM) < 100.0 ? 1 : 0,
                          "Of the eye above sea level, where the ground of the image is"},
                         observer.heightM);
    changed |= numberRow({"observer.azimuth", "Looks to", {0.0, 360.0}, "°", 1, "0 north, 90 east"},
                         observer.azimuthDeg);
    changed |= numberRow({"observer.elevation",
                          "Looks up",
                          {-kMostElevationDeg, kMostElevationDeg},
                          "°",
                          1,
                          "Above the horizon; less than 0 is down"},
                         observer.elevationDeg);
    if (changed) {
        observer.eastM = eastKm * kMPerKm;
        observer.northM = northKm * kMPerKm;
        const auto stood = poseOf(observer, grid);
        tools.outOfReach = !stood;
        if (stood) takeView(pose, *stood);
    }
    if (tools.outOfReach) {
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextColored(warningColour(),
                           "Out of reach: the view must meet the domain or one domain's width "
                           "around it");
        ImGui::PopTextWrapPos();
    }
    ImGui::TreePop();
}

/// Of data whose grid moves.
void drawFixed(const Session& session, CameraPose& pose) {
    const bool moves = session.info() != nullptr && session.info()->moves();
    if (!moves && !pose.fixedToGround) return;
    ImGui::Checkbox("Fixed to the ground", &pose.fixedToGround);
    place("camera.fixed");
    tooltip(
        "Eye and target stay where they are on the ground while the grid moves; else the camera "
        "moves with the grid");
}

void drawFlight(const ActionLookup& actions, CameraTools& tools, const RegularGrid& grid) {
    ImGui::Checkbox("Fly", &tools.flying);
    place("camera.fly");
    tooltip(actions.face("camera.fly").tooltip);
    ImGui::SameLine(0.0f, ImGui::GetFontSize());
    const double extentM = std::max(grid.extentM().x, grid.extentM().y);
    const std::string speed = lengthText(tools.flySpeed * extentM) + "/s";
    ImGui::TextDisabled("%s", speed.c_str());
}

}  // namespace

void drawCamera(const PanelContext& context, CameraTools& tools, Playback& playback) {
    const bool open = ImGui::CollapsingHeader("Camera");
    place("group:Camera");
    if (!open) return;
    CameraPose& pose = context.session().document.camera;
    const RegularGrid grid = gridOf(context.session());
    ImGui::PushID("camera");
    drawViews(context.actions);
    drawPose(pose, grid);
    drawFixed(context.session(), pose);
    drawFlight(context.actions, tools, grid);
    drawObserver(pose, tools, grid);
    drawBookmarks(context, tools);
    drawPath(context, playback);
    ImGui::PopID();
}

}  // namespace neph::ui
