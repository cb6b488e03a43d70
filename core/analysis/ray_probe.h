// ray_probe.h: what a ray of the view meets: where cloud begins, where one sees no further, and
// whose particles are seen.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "core/grid/species.h"
#include "core/look/medium.h"

namespace neph {

/// Optical depth along the ray at which cloud counts as met: 5 % of the light behind is lost.
inline constexpr double kMetDepth = 0.05;
/// ... and as opaque: 5 % are left.
inline constexpr double kOpaqueDepth = 3.0;

struct RayProbe {
    std::optional<glm::dvec3> metM;     ///< where the depth reaches kMetDepth, world space
    std::optional<glm::dvec3> opaqueM;  ///< where it reaches kOpaqueDepth
    double depth = 0.0;                 ///< of the whole ray
    std::array<double, kSpeciesCount> depths{};
    /// Share of each in what the eye sees of the cloud: extinction weighted by what light it leaves
    /// on its way to the eye. They add up to 1 where there is cloud.
    std::array<double, kSpeciesCount> seen{};
    /// Where cloud is met: extinction, 1/m, with the look's mixing scale; content, kg/m³, where
    /// the volume holds contents.
    std::array<double, kSpeciesCount> extinctionPerM{}, contentKgPerM3{};
};

/// Along the unit direction `dirWorld` from `eyeWorld`, without detail below voxels. Steps of half
/// a cell.
RayProbe probeRay(const SpeciesVolume& volume, const MediumPlan& plan, const glm::dvec3& eyeWorld,
                  const glm::dvec3& dirWorld);

}  // namespace neph
