// scattered_radiance.cpp: exact single scattering and the moments of the rest. [Nakajima88]
#include "core/transport/scattered_radiance.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/transport/beam.h"

namespace neph {
namespace {

/// Moment q between the nodes; nodes that are not active count as 0.
double momentBetween(const LightSolver& solver, std::size_t q, const glm::dvec3& atM) {
    const TransportGrid& grid = solver.level().grid;
    const glm::dvec3 at = atM / grid.spacingM;
    const glm::ivec3 low = glm::clamp(glm::ivec3(glm::floor(at)), glm::ivec3(0), grid.nodes - 1);
    const glm::dvec3 share = glm::clamp(at - glm::dvec3(low), 0.0, 1.0);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1.0;
        glm::ivec3 node = low;
        for (int axis = 0; axis < 3; ++axis) {
            const bool upper = ((corner >> axis) & 1) != 0;
            weight *= upper ? share[axis] : 1.0 - share[axis];
            if (upper) ++node[axis];
            if (node[axis] == grid.nodes[axis]) node[axis] = grid.periodic(axis) ? 0 : low[axis];
        }
        const auto moments = solver.momentsAt(grid.index(node.x, node.y, node.z));
        if (!moments.empty()) sum += weight * static_cast<double>(moments[q]);
    }
    return sum;
}

}  // namespace

double scatteredRadiancePerM(const LightSolver& solver, const LightMedium& medium,
                             std::span<const PhaseOfCosine> phases, const glm::dvec3& atM,
                             const glm::dvec3& view) {
    assert(phases.size() == medium.classes.size());
    const TransportLevel& level = solver.level();
    const glm::dvec3 towardsSun = solver.scene().towardsSun;
    std::vector<double> extinction;
    double whole = 0.0;
    for (const LightClass& light : medium.classes) {
        extinction.push_back(trilinear(level.grid, light.extinctionPerM.values, atM));
        whole += extinction.back();
    }
    double single = 0.0;
    std::array<double, kAlignedDegrees> scattering{};
    for (std::size_t s = 0; s < medium.classes.size(); ++s) {
        const LightClass& light = medium.classes[s];
        const auto phase = static_cast<float>(glm::dot(view, towardsSun));
        single += light.singleScattering * extinction[s] * static_cast<double>(phases[s](phase));
        const ScaledOptics scaled = scaledOptics(light, extinction[s], solver.settings().aligned,
                                                 lightThickness(medium, whole));
        for (std::size_t l = 0; l < scattering.size(); ++l) {
            scattering[l] += scaled.scatteringPerM[l];
        }
    }
    const bool lit = !solver.beam().empty();
    double radiance = lit ? single * std::exp(-depthTowards(level, atM, towardsSun)) : 0.0;
    const Harmonics value = harmonicsAt(-view, -towardsSun);
    for (int q = 0; q < solver.momentCount(); ++q) {
        const auto place = static_cast<std::size_t>(q);
        radiance += scattering[static_cast<std::size_t>(degreeOf(q))] *
                    static_cast<double>(value[place]) * momentBetween(solver, place, atM);
    }
    return std::max(0.0, radiance);
}

}  // namespace neph
