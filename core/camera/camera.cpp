// camera.cpp: turntable geometry: azimuth and elevation around a target, no roll.
#include "core/camera/camera.h"

#include <algorithm>
#include <cmath>

namespace neph {
namespace {

constexpr float kPoleDeg = 89.9f;  // looking straight up or down leaves no horizon to level by

/// The unit of distances of a pose: the larger horizontal extent.
double unitM(const RegularGrid& grid) {
    return std::max(grid.extentM().x, grid.extentM().y);
}

/// Clamped, because an exactly vertical view has no right-hand side.
glm::dvec3 towardsEye(const CameraPose& pose) {
    return compassDirWorld(pose.azimuthDeg, std::clamp(pose.elevationDeg, -kPoleDeg, kPoleDeg));
}

}  // namespace

glm::dvec3 Camera::rayDir(glm::dvec2 ndc) const {
    return glm::normalize(forward + right * (ndc.x * tanHalfFovY * aspect) +
                          up * (ndc.y * tanHalfFovY));
}

Camera placeCamera(const CameraPose& pose, const RegularGrid& grid, double aspect) {
    const glm::dvec3 target = grid.originM + grid.extentM() * glm::dvec3(pose.target);
    const glm::dvec3 away = towardsEye(pose);
    Camera camera;
    camera.eyeWorld = target + away * (static_cast<double>(pose.distance) * unitM(grid));
    camera.forward = -away;
    camera.right = glm::normalize(glm::cross(camera.forward, glm::dvec3(0.0, 0.0, 1.0)));
    camera.up = glm::cross(camera.right, camera.forward);
    camera.tanHalfFovY = std::tan(glm::radians(static_cast<double>(pose.fovDeg)) / 2.0);
    camera.aspect = aspect;
    return camera;
}

std::optional<CameraPose> sameView(const CameraPose& pose, const RegularGrid& from,
                                   const RegularGrid& to) {
    const glm::dvec3 targetM = from.originM + from.extentM() * glm::dvec3(pose.target);
    CameraPose same = pose;
    same.target = glm::vec3((targetM - to.originM) / to.extentM());
    same.distance =
        static_cast<float>(static_cast<double>(pose.distance) * unitM(from) / unitM(to));
    const bool near = same.distance >= kMinDistance && same.distance <= kMaxDistance;
    const bool inside = same.target == TargetLimits{}.nearest(same.target);
    if (!near || !inside) return {};
    return same;
}

void keepOnGround(CameraPose& pose, const RegularGrid& grid, glm::dvec2 movedM) {
    if (!pose.fixedToGround) return;
    const glm::dvec2 share = movedM / glm::dvec2(grid.extentM());
    pose.target = TargetLimits{}.nearest(pose.target - glm::vec3(glm::vec2(share), 0.0f));
}

void orbit(CameraPose& pose, float azimuthStepDeg, float elevationStepDeg) {
    pose.azimuthDeg = std::fmod(pose.azimuthDeg + azimuthStepDeg + 720.0f, 360.0f);
    pose.elevationDeg = std::clamp(pose.elevationDeg + elevationStepDeg, -kPoleDeg, kPoleDeg);
}

void pan(CameraPose& pose, const RegularGrid& grid, glm::vec2 step) {
    const Camera camera = placeCamera(pose, grid, 1.0);
    const double heightM =
        2.0 * camera.tanHalfFovY * static_cast<double>(pose.distance) * unitM(grid);
    // The scene follows the cursor, so the target moves the opposite way.
    const glm::dvec3 moveM =
        (camera.right * static_cast<double>(-step.x) + camera.up * static_cast<double>(-step.y)) *
        heightM;
    pose.target += glm::vec3(moveM / grid.extentM());
    pose.target = TargetLimits{}.nearest(pose.target);
}

void dolly(CameraPose& pose, float factor) {
    pose.distance = std::clamp(pose.distance * factor, kMinDistance, kMaxDistance);
}

}  // namespace neph
