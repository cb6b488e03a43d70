// transport_level.cpp: makes the grids, and carries fields between them.
//
// Node i of a fine axis lies at i / 2 of the coarse one: an even node has one parent and an odd
// node two. Both are written as two halves, (i + 0) / 2 and (i + 1) / 2.
#include "core/transport/transport_level.h"

#include <algorithm>
#include <cmath>

#include "core/transport/grid_loops.h"

namespace neph {
namespace {

constexpr int kParents = 8;
constexpr float kShare = 1.0f / kParents;

bool halves(const TransportGrid& grid, int axis) {
    if (grid.periodic(axis)) return grid.nodes[axis] >= 4 && grid.nodes[axis] % 2 == 0;
    return grid.nodes[axis] >= 3;
}

TransportGrid halfGrid(const TransportGrid& fine) {
    TransportGrid coarse = fine;
    for (int axis = 0; axis < 3; ++axis) {
        if (!halves(fine, axis)) continue;
        coarse.nodes[axis] = fine.nodes[axis] / 2 + (fine.periodic(axis) ? 0 : 1);
        coarse.spacingM[axis] *= 2.0;
    }
    return coarse;
}

/// Coarse indices of the parents of each fine index, along one axis.
class Parents {
  public:
    Parents(const TransportGrid& fine, const TransportGrid& coarse) : coarse_(coarse) {
        for (int axis = 0; axis < 3; ++axis) halved_[axis] = halves(fine, axis);
    }
    std::size_t of(const glm::ivec3& node, int parent) const {
        glm::ivec3 at = node;
        for (int axis = 0; axis < 3; ++axis) {
            if (!halved_[axis]) continue;
            at[axis] = (node[axis] + ((parent >> axis) & 1)) / 2;
            if (at[axis] == coarse_.nodes[axis]) at[axis] = 0;
        }
        return coarse_.index(at.x, at.y, at.z);
    }

  private:
    TransportGrid coarse_;
    glm::bvec3 halved_{false};
};

void markAround(const TransportGrid& grid, const glm::ivec3& node,
                std::vector<std::int32_t>& place) {
    for (const int z : beside(grid, 2, node.z)) {
        for (const int y : beside(grid, 1, node.y)) {
            for (const int x : beside(grid, 0, node.x)) {
                if (x >= 0 && y >= 0 && z >= 0) place[grid.index(x, y, z)] = 0;
            }
        }
    }
}

void addValues(std::vector<float>& sum, const std::vector<float>& term) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += term[i];
}

}  // namespace

void addTo(LightField& sum, const LightField& term) {
    addValues(sum.moments, term.moments);
    addValues(sum.groundFlux, term.groundFlux);
}

void TransportLevel::numberActive() {
    place.assign(grid.nodeCount(), -1);
    forEachNode(grid, [&](const glm::ivec3& node, std::size_t index) {
        if (extinctionPerM[index] > 0.0f) markAround(grid, node, place);
    });
    activeCount = 0;
    for (std::int32_t& number : place) {
        if (number == 0) number = static_cast<std::int32_t>(activeCount++);
    }
    albedo.assign(activeCount * static_cast<std::size_t>(degreeCount), 0.0f);
}

float* TransportLevel::albedoAt(std::size_t node) {
    return &albedo[static_cast<std::size_t>(place[node]) * static_cast<std::size_t>(degreeCount)];
}

void TransportLevel::setBalanced() {
    constexpr float kFrom = 0.2f, kWhole = 0.8f;
    const auto lengthM = static_cast<float>(thicknessLengthM(grid.spacingM));
    balanced.assign(grid.nodeCount(), 0.0f);
    for (std::size_t node = 0; node < place.size(); ++node) {
        if (place[node] < 0) continue;
        const float depth = aroundPerM[static_cast<std::size_t>(place[node])] * lengthM;
        balanced[node] = glm::smoothstep(kFrom, kWhole, depth);
    }
}

LightField TransportLevel::emptyField() const {
    LightField field;
    field.moments.assign(activeCount * static_cast<std::size_t>(momentCount), 0.0f);
    field.groundFlux.assign(grid.columnCount(), 0.0f);
    return field;
}

std::size_t TransportLevel::bytes() const {
    return sizeof(float) * (extinctionPerM.size() + thickness.size() + albedo.size() +
                            aroundPerM.size() + balanced.size()) +
           sizeof(std::int32_t) * place.size();
}

bool canCoarsen(const TransportGrid& grid) {
    return halfGrid(grid).nodeCount() < grid.nodeCount();
}

TransportLevel coarsened(const TransportLevel& fine) {
    TransportLevel coarse;
    coarse.grid = halfGrid(fine.grid);
    coarse.momentCount = fine.momentCount;
    coarse.degreeCount = fine.degreeCount;
    const Parents parents(fine.grid, coarse.grid);
    coarse.extinctionPerM.assign(coarse.grid.nodeCount(), 0.0f);
    std::vector<float> children(coarse.grid.nodeCount(), 0.0f);
    forEachNode(fine.grid, [&](const glm::ivec3& at, std::size_t node) {
        for (int p = 0; p < kParents; ++p) {
            const std::size_t parent = parents.of(at, p);
            children[parent] += kShare;
            coarse.extinctionPerM[parent] += kShare * fine.extinctionPerM[node];
        }
    });
    for (std::size_t i = 0; i < children.size(); ++i) coarse.extinctionPerM[i] /= children[i];
    coarse.numberActive();
    if (fine.thick()) coarse.aroundPerM.assign(coarse.activeCount, 0.0f);
    std::vector<float> weights(coarse.grid.nodeCount(), 0.0f);
    const auto degrees = static_cast<std::size_t>(fine.degreeCount);
    forEachNode(fine.grid, [&](const glm::ivec3& at, std::size_t node) {
        const float share = kShare * fine.weightAt(node);
        if (share <= 0.0f) return;
        const float* from = &fine.albedo[static_cast<std::size_t>(fine.place[node]) * degrees];
        for (int p = 0; p < kParents; ++p) {
            const std::size_t parent = parents.of(at, p);
            weights[parent] += share;
            float* to = coarse.albedoAt(parent);
            for (std::size_t l = 0; l < degrees; ++l) to[l] += share * from[l];
        }
    });
    for (std::size_t node = 0; node < weights.size(); ++node) {
        const float sum = weights[node];
        if (sum <= 0.0f) continue;
        for (std::size_t l = 0; l < degrees; ++l) coarse.albedoAt(node)[l] /= sum;
        if (!fine.thick()) continue;
        coarse.aroundPerM[static_cast<std::size_t>(coarse.place[node])] = sum / children[node];
    }
    if (fine.thick()) coarse.setBalanced();
    return coarse;
}

LightField restricted(const TransportLevel& fine, const TransportLevel& coarse,
                      const LightField& after, const LightField& before) {
    LightField field = coarse.emptyField();
    const Parents parents(fine.grid, coarse.grid);
    const auto moments = static_cast<std::size_t>(fine.momentCount);
    std::vector<float> weight(coarse.activeCount, 0.0f);
    std::vector<float> columns(coarse.grid.columnCount(), 0.0f);
    forEachNode(fine.grid, [&](const glm::ivec3& at, std::size_t node) {
        for (int p = 0; at.z == 0 && p < 4; ++p) {
            const std::size_t parent = parents.of(at, p);
            columns[parent] += 1.0f;
            field.groundFlux[parent] += after.groundFlux[node] - before.groundFlux[node];
        }
        const float share = kShare * fine.weightAt(node);
        if (share <= 0.0f) return;
        const std::size_t from = static_cast<std::size_t>(fine.place[node]) * moments;
        for (int p = 0; p < kParents; ++p) {
            const auto to = static_cast<std::size_t>(coarse.place[parents.of(at, p)]);
            weight[to] += share;
            for (std::size_t q = 0; q < moments; ++q) {
                field.moments[to * moments + q] +=
                    share * (after.moments[from + q] - before.moments[from + q]);
            }
        }
    });
    for (std::size_t i = 0; i < field.moments.size(); ++i) {
        const float sum = weight[i / moments];
        if (sum > 0.0f) field.moments[i] /= sum;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) field.groundFlux[i] /= columns[i];
    return field;
}

void addProlonged(const TransportLevel& fine, const TransportLevel& coarse,
                  const LightField& correction, float part, LightField& field) {
    const Parents parents(fine.grid, coarse.grid);
    const auto moments = static_cast<std::size_t>(fine.momentCount);
    forEachNode(fine.grid, [&](const glm::ivec3& at, std::size_t node) {
        for (int p = 0; at.z == 0 && p < 4; ++p) {
            field.groundFlux[node] += part * correction.groundFlux[parents.of(at, p)] / 4.0f;
        }
        if (fine.place[node] < 0) return;
        const std::size_t to = static_cast<std::size_t>(fine.place[node]) * moments;
        for (int p = 0; p < kParents; ++p) {
            const std::int32_t place = coarse.place[parents.of(at, p)];
            if (place < 0) continue;
            const std::size_t from = static_cast<std::size_t>(place) * moments;
            for (std::size_t q = 0; q < moments; ++q) {
                field.moments[to + q] += kShare * part * correction.moments[from + q];
            }
        }
    });
}

}  // namespace neph
