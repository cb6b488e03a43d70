// optical_depth.h: optical depth of each field along one ray.
//
// World space, metres. The held values are trilinear between the centres of their cells and
// constant beyond the outermost; detail noise is not included.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <numeric>

#include "core/grid/species.h"
#include "core/look/medium.h"

namespace neph {

/// The part of a ray within a box, in metres from the eye; empty if `from` is not below `to`.
struct RaySpan {
    double from = 0.0, to = 0.0;
    bool empty() const { return from >= to; }
};
RaySpan spanWithin(const RegularGrid& grid, const glm::dvec3& eyeWorld, const glm::dvec3& dirWorld);

/// Trilinear interpolation; `at` is in cells from the lower corner, so that centres are at halves.
double trilinear(const Array3f& field, const glm::dvec3& at);

/// Optical depth of each species.
struct OpticalDepth {
    std::array<double, kSpeciesCount> of{};  ///< 0 where absent or invisible
    double total() const { return std::accumulate(of.begin(), of.end(), 0.0); }
};

/// Along the ray from `eyeWorld` in the unit direction `dirWorld`, with the extinction of `plan`,
/// Eq. 9: trapezoidal rule with steps of at most half a cell.
OpticalDepth opticalDepthAlong(const SpeciesVolume& volume, const MediumPlan& plan,
                               const glm::dvec3& eyeWorld, const glm::dvec3& dirWorld);

}  // namespace neph
