// camera_moves.cpp: camera moves defined by the eye rather than by the target.
#include "core/camera/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace neph {
namespace {

constexpr double kMargin = 0.05;      // of half the image, around what must fit; tuned by eye
constexpr double kLeastAhead = 0.02;  // least distance of an observer's target, in larger extents
constexpr float kPoleDeg = 89.9f;     // as in orbit()
constexpr float kAlongGroundDeg = 0.0f;  // elevation of an eye that looks from a side

double unitM(const RegularGrid& grid) {
    return std::max(grid.extentM().x, grid.extentM().y);
}

glm::dvec3 targetM(const CameraPose& pose, const RegularGrid& grid) {
    return grid.originM + grid.extentM() * glm::dvec3(pose.target);
}

glm::vec3 shareOf(const glm::dvec3& pointM, const RegularGrid& grid) {
    return glm::vec3((pointM - grid.originM) / grid.extentM());
}

/// The equivalent angle in [0, 360).
float turn(double deg) {
    return static_cast<float>(deg - 360.0 * std::floor(deg / 360.0));
}

/// The constraints that the corners of a box put on the eye, along one image axis. The eye at (c,
/// z_eye) sees x at depth z within a slope t where x - t z <= c - t z_eye and x + t z >= c + t
/// z_eye for every corner: two limits, which meet where the eye is closest.
struct Wedge {
    double most = -std::numeric_limits<double>::max();  // of x - t z
    double least = std::numeric_limits<double>::max();  // of x + t z
    void add(double x, double z, double slope) {
        most = std::max(most, x - slope * z);
        least = std::min(least, x + slope * z);
    }
    double middle() const { return (most + least) / 2.0; }
    double eyeAt(double slope) const { return (least - most) / (2.0 * slope); }
};

/// Moves the eye along its view direction, and sideways, until the boxes just fit.
void fitBoxes(CameraPose& pose, const RegularGrid& grid, std::span<const BoxM> boxes,
              double aspect) {
    const Camera camera = placeCamera(pose, grid, aspect);
    const double up = camera.tanHalfFovY * (1.0 - kMargin), across = up * aspect;
    constexpr double kMost = std::numeric_limits<double>::max();
    Wedge horizontal, vertical;
    double near = kMost, far = -kMost;
    for (const BoxM& box : boxes) {
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 p{(corner & 1) != 0 ? box.upperM.x : box.lowerM.x,
                               (corner & 2) != 0 ? box.upperM.y : box.lowerM.y,
                               (corner & 4) != 0 ? box.upperM.z : box.lowerM.z};
            const double depth = glm::dot(p, camera.forward);
            horizontal.add(glm::dot(p, camera.right), depth, across);
            vertical.add(glm::dot(p, camera.up), depth, up);
            near = std::min(near, depth);
            far = std::max(far, depth);
        }
    }
    const double eye = std::min(horizontal.eyeAt(across), vertical.eyeAt(up));
    const double depth = (near + far) / 2.0;
    const glm::dvec3 target =
        camera.right * horizontal.middle() + camera.up * vertical.middle() + camera.forward * depth;
    pose.target = TargetLimits{}.nearest(shareOf(target, grid));
    pose.distance =
        std::clamp(static_cast<float>((depth - eye) / unitM(grid)), kMinDistance, kMaxDistance);
}

}  // namespace

void zoomTo(CameraPose& pose, const RegularGrid& grid, glm::dvec2 ndc, double aspect,
            float factor) {
    const Camera camera = placeCamera(pose, grid, aspect);
    const glm::dvec3 target = targetM(pose, grid);
    // Half the image height at the distance of the target.
    const double half = camera.tanHalfFovY * static_cast<double>(pose.distance) * unitM(grid);
    const glm::dvec3 point =
        target + camera.right * (ndc.x * half * aspect) + camera.up * (ndc.y * half);
    const float before = pose.distance;
    dolly(pose, factor);
    const double scale = static_cast<double>(pose.distance) / static_cast<double>(before);
    const glm::dvec3 moved = point + (target - point) * scale;
    pose.target = TargetLimits{}.nearest(shareOf(moved, grid));
}

bool standAt(CameraPose& pose, const RegularGrid& grid, const glm::dvec3& eyeM) {
    const glm::dvec3 forward = placeCamera(pose, grid, 1.0).forward;
    // Distances at which the target is within its limits: intersection of a ray and a box.
    const TargetLimits limits;
    double near = static_cast<double>(kMinDistance) * unitM(grid);
    double far = static_cast<double>(kMaxDistance) * unitM(grid);
    for (int i = 0; i < 3; ++i) {
        const double lower =
            grid.originM[i] + static_cast<double>(limits.lower[i]) * grid.extentM()[i];
        const double upper =
            grid.originM[i] + static_cast<double>(limits.upper[i]) * grid.extentM()[i];
        if (std::abs(forward[i]) < 1e-12) {
            if (eyeM[i] < lower || eyeM[i] > upper) return false;
            continue;
        }
        const double a = (lower - eyeM[i]) / forward[i], b = (upper - eyeM[i]) / forward[i];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    if (!(near <= far)) return false;
    const double ahead = std::clamp(static_cast<double>(pose.distance) * unitM(grid), near, far);
    pose.target = limits.nearest(shareOf(eyeM + forward * ahead, grid));
    pose.distance = std::clamp(static_cast<float>(ahead / unitM(grid)), kMinDistance, kMaxDistance);
    return true;
}

bool fly(CameraPose& pose, const RegularGrid& grid, const glm::dvec3& stepM) {
    const Camera camera = placeCamera(pose, grid, 1.0);
    return standAt(pose, grid,
                   camera.eyeWorld + camera.right * stepM.x + glm::dvec3(0.0, 0.0, stepM.y) +
                       camera.forward * stepM.z);
}

bool lookAround(CameraPose& pose, const RegularGrid& grid, float rightDeg, float upDeg) {
    const glm::dvec3 eye = placeCamera(pose, grid, 1.0).eyeWorld;
    CameraPose turned = pose;
    orbit(turned, rightDeg, -upDeg);
    if (!standAt(turned, grid, eye)) return false;
    pose = turned;
    return true;
}

Observer observerOf(const CameraPose& pose, const RegularGrid& grid) {
    const glm::dvec3 eye = placeCamera(pose, grid, 1.0).eyeWorld;
    return {eye.x,
            eye.y,
            eye.z,
            static_cast<double>(turn(static_cast<double>(pose.azimuthDeg) + 180.0)),
            -static_cast<double>(pose.elevationDeg),
            static_cast<double>(pose.fovDeg)};
}

std::optional<CameraPose> poseOf(const Observer& observer, const RegularGrid& grid) {
    CameraPose pose;
    pose.azimuthDeg = turn(observer.azimuthDeg + 180.0);
    pose.elevationDeg = std::clamp(static_cast<float>(-observer.elevationDeg), -90.0f, 90.0f);
    pose.fovDeg = std::clamp(static_cast<float>(observer.fovDeg), kMinFovDeg, kMaxFovDeg);
    const glm::dvec3 eye{observer.eastM, observer.northM, observer.heightM};
    const glm::dvec3 middle = grid.originM + grid.extentM() / 2.0;
    const double ahead = glm::dot(middle - eye, placeCamera(pose, grid, 1.0).forward);
    pose.distance = static_cast<float>(std::max(ahead / unitM(grid), kLeastAhead));
    if (!standAt(pose, grid, eye)) return {};
    return pose;
}

void takeView(CameraPose& pose, const CameraPose& view) {
    const bool fixed = pose.fixedToGround;
    pose = view;
    pose.fixedToGround = fixed;
}

CameraPose viewOf(View view, CameraPose pose, const RegularGrid& grid, std::span<const BoxM> boxes,
                  double aspect) {
    switch (view) {
        case View::fit:
            break;
        case View::plan:
        case View::below:
            pose.azimuthDeg = 180.0f;
            pose.elevationDeg = view == View::plan ? kPoleDeg : -kPoleDeg;
            break;
        default:
            pose.azimuthDeg =
                90.0f * static_cast<float>(static_cast<int>(view) - static_cast<int>(View::north));
            pose.elevationDeg = kAlongGroundDeg;
    }
    fitBoxes(pose, grid, boxes, aspect);
    return pose;
}

std::optional<glm::dvec2> ndcOf(const Camera& camera, const glm::dvec3& pointM) {
    const glm::dvec3 to = pointM - camera.eyeWorld;
    const double depth = glm::dot(to, camera.forward);
    if (depth <= 0.0) return {};
    const double half = camera.tanHalfFovY * depth;
    return glm::dvec2{glm::dot(to, camera.right) / (half * camera.aspect),
                      glm::dot(to, camera.up) / half};
}

}  // namespace neph
