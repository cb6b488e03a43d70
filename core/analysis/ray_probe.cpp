// ray_probe.cpp: goes along a ray once, for all species together.
#include "core/analysis/ray_probe.h"

#include <cmath>

#include "core/volume/optical_depth.h"

namespace neph {
namespace {

constexpr double kStepsPerCell = 2.0;

const Array3f* heldOf(const SpeciesVolume& volume, std::size_t species) {
    const bool sized = volume.holdsExtinction(static_cast<Species>(species));
    const Array3f& field = sized ? volume.extinctionPerM[species] : volume.contentKgPerM3[species];
    return field.empty() ? nullptr : &field;
}

/// Extinction of each species at a place, in cells from the lower corner.
std::array<double, kSpeciesCount> extinctionAt(const SpeciesVolume& volume, const MediumPlan& plan,
                                               const glm::dvec3& at) {
    std::array<double, kSpeciesCount> extinction{};
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const auto perHeld = static_cast<double>(plan.extinctionPerHeld[s]);
        const Array3f* held = perHeld > 0.0 ? heldOf(volume, s) : nullptr;
        if (held != nullptr) extinction[s] = perHeld * trilinear(*held, at);
    }
    return extinction;
}

void describeMet(RayProbe& probe, const SpeciesVolume& volume, const glm::dvec3& at,
                 const std::array<double, kSpeciesCount>& extinction) {
    probe.extinctionPerM = extinction;
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        if (!volume.contentKgPerM3[s].empty()) {
            probe.contentKgPerM3[s] = trilinear(volume.contentKgPerM3[s], at);
        }
    }
}

}  // namespace

RayProbe probeRay(const SpeciesVolume& volume, const MediumPlan& plan, const glm::dvec3& eyeWorld,
                  const glm::dvec3& dirWorld) {
    RayProbe probe;
    const RegularGrid& grid = volume.grid;
    const RaySpan span = spanWithin(grid, eyeWorld, dirWorld);
    if (span.empty()) return probe;
    const double cellsPerM = glm::length(dirWorld / grid.spacingM);
    const int steps =
        std::max(1, static_cast<int>(std::ceil(kStepsPerCell * cellsPerM * (span.to - span.from))));
    const double stepM = (span.to - span.from) / steps;
    double seenAll = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double atM = span.from + (i + 0.5) * stepM;
        const glm::dvec3 cell = (eyeWorld + atM * dirWorld - grid.originM) / grid.spacingM;
        const auto extinction = extinctionAt(volume, plan, cell);
        double sum = 0.0;
        for (const double each : extinction) sum += each;
        if (sum <= 0.0) continue;
        // Where within the step a depth is reached.
        const auto placeOf = [&](double depth) {
            return eyeWorld + (atM - 0.5 * stepM + (depth - probe.depth) / sum) * dirWorld;
        };
        const double after = probe.depth + sum * stepM;
        if (!probe.metM && after >= kMetDepth) {
            probe.metM = placeOf(kMetDepth);
            describeMet(probe, volume, cell, extinction);
        }
        if (!probe.opaqueM && after >= kOpaqueDepth) probe.opaqueM = placeOf(kOpaqueDepth);
        const double seen = std::exp(-probe.depth) - std::exp(-after);
        seenAll += seen;
        for (std::size_t s = 0; s < kSpeciesCount; ++s) {
            probe.depths[s] += extinction[s] * stepM;
            probe.seen[s] += seen * extinction[s] / sum;
        }
        probe.depth = after;
    }
    if (seenAll > 0.0) {
        for (double& share : probe.seen) share /= seenAll;
    }
    return probe;
}

}  // namespace neph
