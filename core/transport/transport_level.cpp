// transport_level.cpp: makes the grids, and carries fields between them.
//
// Node i of a fine axis lies at i / 2 of the coarse one: an even node has one parent and an odd
// node two, which share it equally.
#include "core/transport/transport_level.h"

#include <algorithm>
#include <cmath>

#include "core/transport/grid_loops.h"

namespace neph {
namespace {

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

/// The coarse nodes that a fine one belongs to, in equal shares.
class Parents {
  public:
    Parents(const TransportGrid& fine, const TransportGrid& coarse) : coarse_(coarse) {
        for (int axis = 0; axis < 3; ++axis) halved_[axis] = halves(fine, axis);
    }
    /// `visit(index, share)` of each.
    template <typename Visit>
    void forEach(const glm::ivec3& node, const Visit& visit) const {
        glm::ivec3 low = node, high = node;
        for (int axis = 0; axis < 3; ++axis) {
            if (!halved_[axis]) continue;
            low[axis] = node[axis] / 2;
            high[axis] = (node[axis] + 1) / 2;
        }
        const glm::ivec3 count = high - low + 1;
        const float share = 1.0f / static_cast<float>(count.x * count.y * count.z);
        for (int k = low.z; k <= high.z; ++k) {
            for (int j = low.y; j <= high.y; ++j) {
                for (int i = low.x; i <= high.x; ++i) visit(indexOf({i, j, k}), share);
            }
        }
    }

  private:
    /// Beyond the last node of a periodic axis is the first.
    std::size_t indexOf(const glm::ivec3& node) const {
        const glm::ivec3 at = glm::mix(node, glm::ivec3(0), glm::equal(node, coarse_.nodes));
        return coarse_.index(at.x, at.y, at.z);
    }

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
    numberMarked();
}

void TransportLevel::numberAll() {
    place.assign(grid.nodeCount(), 0);
    numberMarked();
}

/// Nodes whose place is 0.
void TransportLevel::numberMarked() {
    activeCount = 0;
    for (std::int32_t& number : place) {
        if (number == 0) number = static_cast<std::int32_t>(activeCount++);
    }
    albedo.assign(activeCount * static_cast<std::size_t>(degreeCount), 0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        const int along = sliceAxes(axis)[0], across = sliceAxes(axis)[1];
        const int rows = grid.nodes[across];
        auto& spans = activeRows[static_cast<std::size_t>(axis)];
        spans.assign(static_cast<std::size_t>(grid.nodes[axis] * rows), {});
        forEachNode(grid, [&](const glm::ivec3& node, std::size_t index) {
            if (place[index] < 0) return;
            spans[static_cast<std::size_t>(node[axis] * rows + node[across])].include(node[along]);
        });
    }
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
        parents.forEach(at, [&](std::size_t parent, float share) {
            children[parent] += share;
            coarse.extinctionPerM[parent] += share * fine.extinctionPerM[node];
        });
    });
    for (std::size_t i = 0; i < children.size(); ++i) coarse.extinctionPerM[i] /= children[i];
    coarse.numberActive();
    if (fine.thick()) coarse.aroundPerM.assign(coarse.activeCount, 0.0f);
    std::vector<float> weights(coarse.grid.nodeCount(), 0.0f);
    const auto degrees = static_cast<std::size_t>(fine.degreeCount);
    forEachNode(fine.grid, [&](const glm::ivec3& at, std::size_t node) {
        const float weight = fine.weightAt(node);
        if (weight <= 0.0f) return;
        const float* from = &fine.albedo[static_cast<std::size_t>(fine.place[node]) * degrees];
        parents.forEach(at, [&](std::size_t parent, float share) {
            weights[parent] += share * weight;
            float* to = coarse.albedoAt(parent);
            for (std::size_t l = 0; l < degrees; ++l) to[l] += share * weight * from[l];
        });
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
        if (at.z == 0) {
            parents.forEach(at, [&](std::size_t parent, float share) {
                columns[parent] += share;
                field.groundFlux[parent] +=
                    share * (after.groundFlux[node] - before.groundFlux[node]);
            });
        }
        const float ofNode = fine.weightAt(node);
        if (ofNode <= 0.0f) return;
        const std::size_t from = static_cast<std::size_t>(fine.place[node]) * moments;
        parents.forEach(at, [&](std::size_t parent, float share) {
            const auto to = static_cast<std::size_t>(coarse.place[parent]);
            weight[to] += share * ofNode;
            for (std::size_t q = 0; q < moments; ++q) {
                field.moments[to * moments + q] +=
                    share * ofNode * (after.moments[from + q] - before.moments[from + q]);
            }
        });
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
        if (at.z == 0) {
            parents.forEach(at, [&](std::size_t parent, float share) {
                field.groundFlux[node] += part * share * correction.groundFlux[parent];
            });
        }
        if (fine.place[node] < 0) return;
        const std::size_t to = static_cast<std::size_t>(fine.place[node]) * moments;
        parents.forEach(at, [&](std::size_t parent, float share) {
            if (coarse.place[parent] < 0) return;
            const std::size_t from = static_cast<std::size_t>(coarse.place[parent]) * moments;
            for (std::size_t q = 0; q < moments; ++q) {
                field.moments[to + q] += share * part * correction.moments[from + q];
            }
        });
    });
}

}  // namespace neph
