// slice_plan.cpp: choosing the slices' normal, extent and light buffer.
#include "app/render/light/slice_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace neph::render {
namespace {

// Between a pixel's ray and the normal; beyond it samples lie six slices apart. Tuned by eye, as
// are the bounds of the light buffer.
constexpr double kSteepestRayDeg = 80.0;
constexpr int kMinLightPx = 16, kMaxLightPx = 1024;
constexpr int kMostLevelSlices = 4096;

struct Extent {
    double lo = 1e300, hi = -1e300;
    void include(double x) {
        lo = std::min(lo, x);
        hi = std::max(hi, x);
    }
    double length() const { return hi - lo; }
};

Extent along(glm::dvec3 axis, const BoxM& box) {
    Extent extent;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p{(corner & 1) ? box.upperM.x : box.lowerM.x,
                           (corner & 2) ? box.upperM.y : box.lowerM.y,
                           (corner & 4) ? box.upperM.z : box.lowerM.z};
        extent.include(glm::dot(axis, p));
    }
    return extent;
}

/// Halfway from `axis` to `travel` (both unit, at most 90° apart), but no further than keeps every
/// pixel's ray off the slices.
glm::dvec3 halfway(glm::dvec3 axis, glm::dvec3 travel, double cornerRad) {
    const double between = std::acos(std::clamp(glm::dot(axis, travel), -1.0, 1.0));
    const double turn = std::min(between / 2.0, glm::radians(kSteepestRayDeg) - cornerRad);
    if (between < 1e-6) return axis;
    const glm::dvec3 across = glm::normalize(travel - axis * glm::dot(axis, travel));
    return axis * std::cos(turn) + across * std::sin(turn);
}

int lightSize(double extentM, double texelM) {
    return std::clamp(static_cast<int>(std::ceil(extentM / texelM)), kMinLightPx, kMaxLightPx);
}

/// Spreads `count` slices along plan.normal over the box.
void layOut(SlicePlan& plan, glm::dvec3 towardsSun, const BoxM& box, int count) {
    const Extent depth = along(plan.normal, box);
    plan.count = count;
    plan.firstM = depth.lo;
    plan.spacingM = depth.length() / count;
    plan.lightStepM = plan.spacingM / glm::dot(plan.normal, -towardsSun);
}

/// The light buffer: the box as the sun sees it.
void layLight(SlicePlan& plan, glm::dvec3 towardsSun, const BoxM& box, double texelM) {
    const glm::dvec3 helper =
        std::abs(towardsSun.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    plan.lightU = glm::normalize(glm::cross(helper, towardsSun));
    plan.lightV = glm::cross(towardsSun, plan.lightU);
    const Extent u = along(plan.lightU, box), v = along(plan.lightV, box);
    plan.lightLowerM = {u.lo, v.lo};
    plan.lightExtentM = {u.length(), v.length()};
    plan.lightSizePx = {lightSize(u.length(), texelM), lightSize(v.length(), texelM)};
}

}  // namespace

SlicePlan planSlices(const Camera& camera, glm::dvec3 towardsSun, const BoxM& box, int planes,
                     double texelM) {
    SlicePlan plan;
    const glm::dvec3 travel = -towardsSun;
    plan.frontToBack = glm::dot(camera.forward, travel) >= 0.0;
    const glm::dvec3 axis = plan.frontToBack ? camera.forward : -camera.forward;
    const double cornerRad =
        std::atan(camera.tanHalfFovY * std::sqrt(1.0 + camera.aspect * camera.aspect));
    plan.normal = halfway(axis, travel, cornerRad);

    layOut(plan, towardsSun, box, planes);
    // A texel finer than the slices are apart would only repeat what they saw. The same for every
    // camera, so that an orbit keeps its buffers.
    layLight(plan, towardsSun, box,
             std::max(texelM, glm::length(box.upperM - box.lowerM) / planes));
    return plan;
}

SlicePlan planSunSlices(glm::dvec3 towardsSun, const BoxM& box, double stepM) {
    SlicePlan plan;
    plan.normal = -towardsSun;
    const double depthM = along(plan.normal, box).length();
    layOut(plan, towardsSun, box, std::max(1, static_cast<int>(std::ceil(depthM / stepM))));
    layLight(plan, towardsSun, box, stepM);
    return plan;
}

SlicePlan planRepeatedSlices(glm::dvec3 towardsSun, const BoxM& occupied, glm::dvec3 extentM,
                             double stepM) {
    SlicePlan plan;
    plan.repeats = true;
    plan.normal = {0.0, 0.0, towardsSun.z < 0.0 ? 1.0 : -1.0};
    const double heightM = occupied.upperM.z - occupied.lowerM.z;
    const double slices = std::ceil(heightM / (std::abs(towardsSun.z) * stepM));
    layOut(plan, towardsSun, occupied,
           static_cast<int>(std::clamp(slices, 1.0, static_cast<double>(kMostLevelSlices))));
    plan.lightU = {1.0, 0.0, -towardsSun.x / towardsSun.z};
    plan.lightV = {0.0, 1.0, -towardsSun.y / towardsSun.z};
    plan.lightExtentM = extentM;
    plan.lightSizePx = {lightSize(extentM.x, stepM), lightSize(extentM.y, stepM)};
    return plan;
}

void SlicePlan::limit(int most) {
    if (count <= most) return;
    spacingM *= static_cast<double>(count) / most;
    lightStepM *= static_cast<double>(count) / most;
    count = most;
}

}  // namespace neph::render
