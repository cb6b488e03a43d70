// source_moments.cpp: moments of the field times what is scattered of them.
#include "core/transport/source_moments.h"

#include <cstddef>

#include "core/transport/grid_loops.h"

namespace neph {
namespace {

/// Calls `visit(node)` for a node and those around it.
template <typename Visit>
void forNeighbours(const TransportGrid& grid, const glm::ivec3& at, const Visit& visit) {
    for (const int k : beside(grid, 2, at.z)) {
        for (const int j : beside(grid, 1, at.y)) {
            for (const int i : beside(grid, 0, at.x)) {
                if (i >= 0 && j >= 0 && k >= 0) visit(grid.index(i, j, k));
            }
        }
    }
}

/// Adds the albedo of a node times its extinction, which is returned.
float addAlbedo(const TransportLevel& level, std::size_t node, float* sum) {
    const float extinction = level.extinctionPerM[node];
    if (extinction <= 0.0f) return 0.0f;
    const float* albedo = level.albedoAt(node);
    for (int l = 0; l < level.degreeCount; ++l) sum[l] += extinction * albedo[l];
    return extinction;
}

/// Moments of the beam of irradiance 1.
Harmonics beamMoments(const LightSolver& solver) {
    const glm::dvec3 travel = -solver.scene().towardsSun;
    return harmonicsAt(travel, travel);
}

}  // namespace

std::vector<float> filledAlbedo(const TransportLevel& level) {
    std::vector<float> filled = level.albedo;
    const auto degrees = static_cast<std::size_t>(level.degreeCount);
    forEachNode(level.grid, [&](const glm::ivec3& at, std::size_t node) {
        if (level.place[node] < 0 || level.extinctionPerM[node] > 0.0f) return;
        float* to = &filled[static_cast<std::size_t>(level.place[node]) * degrees];
        if (to[0] > 0.0f) return;
        float extinction = 0.0f;
        forNeighbours(level.grid, at,
                      [&](std::size_t other) { extinction += addAlbedo(level, other, to); });
        for (std::size_t l = 0; l < degrees && extinction > 0.0f; ++l) to[l] /= extinction;
    });
    return filled;
}

std::vector<float> sourceMoments(const LightSolver& solver, const std::vector<float>& albedo,
                                 int degrees) {
    const TransportLevel& level = solver.level();
    const auto moments = static_cast<std::size_t>(solver.momentCount());
    const Harmonics ofBeam = beamMoments(solver);
    std::vector<float> source = solver.field().moments;
    for (std::size_t node = 0; node < level.place.size(); ++node) {
        if (level.place[node] < 0) continue;
        const auto place = static_cast<std::size_t>(level.place[node]);
        const bool lit = level.thick() && !solver.beam().empty();
        const float beam = lit ? level.balanced[node] * solver.beam()[node] : 0.0f;
        const float* of = &albedo[place * static_cast<std::size_t>(degrees)];
        for (std::size_t q = 0; q < moments; ++q) {
            float& value = source[place * moments + q];
            value = of[degreeOf(static_cast<int>(q))] * (value + beam * ofBeam[q]);
        }
    }
    return source;
}

std::vector<float> balancedAlbedo(const TransportLevel& level, std::vector<float> albedo) {
    if (!level.thick()) return {};
    const auto degrees = static_cast<std::size_t>(level.degreeCount);
    for (std::size_t node = 0; node < level.place.size(); ++node) {
        if (level.place[node] < 0) continue;
        float* of = &albedo[static_cast<std::size_t>(level.place[node]) * degrees];
        for (std::size_t l = 0; l < degrees; ++l) of[l] *= level.balanced[node];
    }
    return albedo;
}

}  // namespace neph
