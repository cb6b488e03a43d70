// optical_depth.cpp: integrates extinction from where the ray enters the box to where it leaves it.
#include "core/volume/optical_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace neph {
namespace {

constexpr double kStepsPerCell = 2.0;

/// Trapezoidal rule, in units of one step.
double integral(const Array3f& field, const glm::dvec3& entry, const glm::dvec3& perStep,
                int steps) {
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i) {
        const double weight = i == 0 || i == steps ? 0.5 : 1.0;
        sum += weight * trilinear(field, entry + perStep * static_cast<double>(i));
    }
    return sum;
}

}  // namespace

double trilinear(const Array3f& field, const glm::dvec3& at) {
    const glm::dvec3 most = glm::dvec3(field.size - 1);
    const glm::dvec3 shifted = glm::clamp(at - 0.5, glm::dvec3(0.0), most);
    const glm::ivec3 low = glm::min(glm::ivec3(shifted), field.size - 1);
    const glm::ivec3 high = glm::min(low + 1, field.size - 1);
    const glm::dvec3 f = shifted - glm::dvec3(low);
    const auto line = [&](int y, int z) {
        return glm::mix(static_cast<double>(field.at(low.x, y, z)),
                        static_cast<double>(field.at(high.x, y, z)), f.x);
    };
    const auto plane = [&](int z) { return glm::mix(line(low.y, z), line(high.y, z), f.y); };
    return glm::mix(plane(low.z), plane(high.z), f.z);
}

RaySpan spanWithin(const RegularGrid& grid, const glm::dvec3& eye, const glm::dvec3& dir) {
    RaySpan span{0.0, std::numeric_limits<double>::infinity()};
    const glm::dvec3 lower = grid.originM, upper = grid.upperM();
    for (int i = 0; i < 3; ++i) {
        if (dir[i] == 0.0) {
            if (eye[i] < lower[i] || eye[i] > upper[i]) span.to = -1.0;
            continue;
        }
        const double a = (lower[i] - eye[i]) / dir[i], b = (upper[i] - eye[i]) / dir[i];
        span.from = std::max(span.from, std::min(a, b));
        span.to = std::min(span.to, std::max(a, b));
    }
    return span;
}

OpticalDepth opticalDepthAlong(const SpeciesVolume& volume, const MediumPlan& plan,
                               const glm::dvec3& eyeWorld, const glm::dvec3& dirWorld) {
    OpticalDepth depth;
    const RegularGrid& grid = volume.grid;
    const RaySpan span = spanWithin(grid, eyeWorld, dirWorld);
    if (span.empty()) return depth;
    const double length = span.to - span.from;
    const double cellsCrossed = glm::length(dirWorld / grid.spacingM) * length;
    const int steps = std::max(1, static_cast<int>(std::ceil(kStepsPerCell * cellsCrossed)));
    const double stepM = length / steps;
    const glm::dvec3 entry = (eyeWorld + dirWorld * span.from - grid.originM) / grid.spacingM;
    const glm::dvec3 perStep = dirWorld * stepM / grid.spacingM;
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const auto perHeld = static_cast<double>(plan.extinctionPerHeld[s]);
        if (perHeld <= 0.0) continue;
        const bool sized = volume.holdsExtinction(static_cast<Species>(s));
        const Array3f& field = sized ? volume.extinctionPerM[s] : volume.contentKgPerM3[s];
        depth.of[s] = perHeld * stepM * integral(field, entry, perStep, steps);
    }
    return depth;
}

}  // namespace neph
