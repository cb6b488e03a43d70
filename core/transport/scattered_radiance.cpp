// scattered_radiance.cpp: exact single scattering and the moments of the rest. [Nakajima88]
#include "core/transport/scattered_radiance.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/transport/beam.h"
#include "core/transport/cell_walk.h"

namespace neph {
namespace {

/// What is interpolated between the nodes around a point.
struct BetweenNodes {
    double thickness = 0.0, balanced = 0.0;
    std::array<double, kAlignedMoments> moments{};  ///< the balanced share of the beam included
};

BetweenNodes betweenNodes(const LightSolver& solver, const Harmonics& ofBeam,
                          const glm::dvec3& atM) {
    const TransportLevel& level = solver.level();
    const TransportGrid& grid = level.grid;
    BetweenNodes result;
    result.thickness = trilinear(grid, level.thickness, atM);
    glm::dvec3 at = atM / grid.spacingM;
    glm::ivec3 cell(0);
    for (int axis = 0; axis < 3; ++axis) {
        const int n = grid.nodes[axis];
        if (grid.periodic(axis)) at[axis] -= n * std::floor(at[axis] / n);
        cell[axis] = std::clamp(static_cast<int>(std::floor(at[axis])), 0,
                                n - (grid.periodic(axis) ? 1 : 2));
    }
    const CellCorners corners(grid, level.extinctionPerM, cell);
    glm::vec3 share(glm::clamp(at - glm::dvec3(cell), 0.0, 1.0));
    if (level.thick()) {
        share = depthShares(corners, static_cast<float>(thicknessLengthM(grid.spacingM)), share);
    }
    for (std::size_t corner = 0; corner < 8; ++corner) {
        double weight = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto upper = static_cast<double>(share[axis]);
            weight *= ((corner >> axis) & 1U) != 0 ? upper : 1.0 - upper;
        }
        const std::size_t node = corners.node[corner];
        const auto moments = solver.momentsAt(node);
        for (std::size_t q = 0; q < moments.size(); ++q) {
            result.moments[q] += weight * static_cast<double>(moments[q]);
        }
        if (!level.thick()) continue;
        const double balanced = weight * static_cast<double>(level.balanced[node]);
        result.balanced += balanced;
        if (solver.beam().empty()) continue;
        const double lit = balanced * static_cast<double>(solver.beam()[node]);
        for (std::size_t q = 0; q < moments.size(); ++q) {
            result.moments[q] += lit * static_cast<double>(ofBeam[q]);
        }
    }
    return result;
}

}  // namespace

double scatteredRadiancePerM(const LightSolver& solver, const LightMedium& medium,
                             std::span<const PhaseOfCosine> phases, const glm::dvec3& atM,
                             const glm::dvec3& view) {
    assert(phases.size() == medium.classes.size());
    const TransportLevel& level = solver.level();
    const glm::dvec3 towardsSun = solver.scene().towardsSun;
    const auto phase = static_cast<float>(glm::dot(view, towardsSun));
    const Harmonics ofBeam = harmonicsAt(-towardsSun, -towardsSun);
    const BetweenNodes between = betweenNodes(solver, ofBeam, atM);
    double single = 0.0;
    std::array<double, kAlignedDegrees> scattering{};
    for (std::size_t s = 0; s < medium.classes.size(); ++s) {
        const LightClass& light = medium.classes[s];
        const double extinction = trilinear(level.grid, light.extinctionPerM.values, atM);
        single += light.singleScattering * extinction * static_cast<double>(phases[s](phase));
        const ScaledOptics scaled =
            scaledOptics(light, extinction, solver.settings().aligned, between.thickness);
        for (std::size_t l = 0; l < scattering.size(); ++l) {
            scattering[l] += scaled.scatteringPerM[l];
        }
    }
    const bool lit = !solver.beam().empty();
    const double beam = lit ? std::exp(-depthTowards(level, atM, towardsSun)) : 0.0;
    // Balanced moments hold the beam, which is scattered here with the complete phase function.
    const double twice = between.balanced * beam;
    double radiance = single * beam;
    const Harmonics value = harmonicsAt(-view, -towardsSun);
    for (int q = 0; q < solver.momentCount(); ++q) {
        const auto place = static_cast<std::size_t>(q);
        radiance += scattering[static_cast<std::size_t>(degreeOf(q))] *
                    static_cast<double>(value[place]) *
                    (between.moments[place] - twice * static_cast<double>(ofBeam[place]));
    }
    return std::max(0.0, radiance);
}

}  // namespace neph
