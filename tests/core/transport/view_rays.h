// view_rays.h: the radiance that leaves a solved medium with periodic sides, along rays of view.
//
// An image is made the same way: what scatteredRadiancePerM sends towards the eye, attenuated with
// the scaled extinction. docs/transport.md
#pragma once
#include <cmath>
#include <numbers>
#include <span>

#include "core/transport/beam.h"
#include "core/transport/scattered_radiance.h"

/// Four times as many of both change the radiances of the step cloud by 0.3 % at most.
inline constexpr int kRaysPerColumn = 2, kStepsPerLayer = 2;

/// Of light that travels along the unit vector `travel` and leaves the top or the base at `exitM`:
/// W/(m² sr) per W/m² of the sun across its beam.
inline double radianceAlong(const neph::LightSolver& solver, const neph::LightMedium& medium,
                            std::span<const neph::PhaseOfCosine> phases, const glm::dvec3& exitM,
                            const glm::dvec3& travel) {
    const neph::TransportLevel& level = solver.level();
    const double heightM = (medium.nodes.z - 1) * medium.spacingM.z;
    const int steps = kStepsPerLayer * (medium.nodes.z - 1);
    const double stepM = heightM / std::abs(travel.z) / steps;
    double radiance = 0.0, through = 1.0;
    for (int i = 0; i < steps; ++i) {
        const glm::dvec3 atM = exitM - travel * ((i + 0.5) * stepM);
        const double perM = neph::trilinear(level.grid, level.extinctionPerM, atM);
        if (perM <= 0.0) continue;
        const double beyond = through * std::exp(-perM * stepM);
        radiance += (through - beyond) / perM *
                    neph::scatteredRadiancePerM(solver, medium, phases, atM, -travel);
        through = beyond;
    }
    return radiance;
}

/// Mean over the top where `travel` points up, over the base else, as I3RC gives it: times pi, over
/// the sun's irradiance on the top. The beam is not part of it. The medium is the same all along y;
/// `phases` are as for scatteredRadiancePerM.
inline double leavingRadiance(const neph::LightSolver& solver, const neph::LightMedium& medium,
                              std::span<const neph::PhaseOfCosine> phases,
                              const glm::dvec3& travel) {
    const int count = medium.nodes.x * kRaysPerColumn;
    const double topM = (medium.nodes.z - 1) * medium.spacingM.z;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 exitM((i + 0.5) / kRaysPerColumn * medium.spacingM.x, 0.0,
                               travel.z > 0.0 ? topM : 0.0);
        sum += radianceAlong(solver, medium, phases, exitM, travel);
    }
    return std::numbers::pi * sum / count / solver.scene().towardsSun.z;
}
