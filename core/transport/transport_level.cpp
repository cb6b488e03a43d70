// transport_level.cpp: makes the grids, and carries fields between them.
//
// Node i of a fine axis lies at i / 2 of the coarse one: an even node has one parent and an odd
// node two. Both are written as two halves, (i + 0) / 2 and (i + 1) / 2.
#include "core/transport/transport_level.h"

#include <algorithm>

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

template <typename Visit>
void forEachNode(const TransportGrid& grid, const Visit& visit) {
    std::size_t index = 0;
    for (int k = 0; k < grid.nodes.z; ++k) {
        for (int j = 0; j < grid.nodes.y; ++j) {
            for (int i = 0; i < grid.nodes.x; ++i) visit(glm::ivec3(i, j, k), index++);
        }
    }
}

/// The nodes beside `at` along one axis, itself included; out of the grid is -1.
std::array<int, 3> beside(const TransportGrid& grid, int axis, int at) {
    const int n = grid.nodes[axis];
    if (grid.periodic(axis)) return {(at + n - 1) % n, at, (at + 1) % n};
    return {at - 1, at, at + 1 < n ? at + 1 : -1};
}

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

/// Numbers the active nodes in the order of all nodes.
void numberActive(TransportLevel& level) {
    level.place.assign(level.grid.nodeCount(), -1);
    forEachNode(level.grid, [&](const glm::ivec3& node, std::size_t index) {
        if (level.extinctionPerM[index] > 0.0f) markAround(level.grid, node, level.place);
    });
    level.activeCount = 0;
    for (std::int32_t& place : level.place) {
        if (place == 0) place = static_cast<std::int32_t>(level.activeCount++);
    }
    level.scatteringPerM.assign(level.activeCount * static_cast<std::size_t>(level.degreeCount),
                                0.0f);
}

float* scatteringAt(TransportLevel& level, std::size_t node) {
    return &level.scatteringPerM[static_cast<std::size_t>(level.place[node]) *
                                 static_cast<std::size_t>(level.degreeCount)];
}

}  // namespace

LightField TransportLevel::emptyField() const {
    LightField field;
    field.moments.assign(activeCount * static_cast<std::size_t>(momentCount), 0.0f);
    field.groundFlux.assign(grid.columnCount(), 0.0f);
    return field;
}

std::size_t TransportLevel::bytes() const {
    return sizeof(float) * (extinctionPerM.size() + scatteringPerM.size()) +
           sizeof(std::int32_t) * place.size();
}

TransportLevel finestLevel(const LightMedium& medium, bool periodicSides, bool aligned,
                           int momentCount) {
    TransportLevel level;
    level.grid = {medium.nodes, medium.spacingM, periodicSides};
    level.momentCount = momentCount;
    level.degreeCount = momentCount == kBroadMoments ? kBroadDegrees : kAlignedDegrees;
    level.extinctionPerM.assign(level.grid.nodeCount(), 0.0f);
    const auto thicknessAt = [&](std::size_t node) {
        double sum = 0.0;
        for (const LightClass& light : medium.classes) {
            sum += static_cast<double>(light.extinctionPerM.values[node]);
        }
        return lightThickness(medium, sum);
    };
    const auto scaledAt = [&](const LightClass& light, std::size_t node, double thickness) {
        return scaledOptics(light, static_cast<double>(light.extinctionPerM.values[node]), aligned,
                            thickness);
    };
    for (std::size_t node = 0; node < level.extinctionPerM.size(); ++node) {
        const double thickness = thicknessAt(node);
        for (const LightClass& light : medium.classes) {
            level.extinctionPerM[node] +=
                static_cast<float>(scaledAt(light, node, thickness).extinctionPerM);
        }
    }
    numberActive(level);
    for (std::size_t node = 0; node < level.place.size(); ++node) {
        if (level.extinctionPerM[node] <= 0.0f) continue;
        const double thickness = thicknessAt(node);
        for (const LightClass& light : medium.classes) {
            const ScaledOptics scaled = scaledAt(light, node, thickness);
            for (int l = 0; l < level.degreeCount; ++l) {
                scatteringAt(level, node)[l] +=
                    static_cast<float>(scaled.scatteringPerM[static_cast<std::size_t>(l)]);
            }
        }
    }
    return level;
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
    std::vector<float> weight(coarse.grid.nodeCount(), 0.0f);
    forEachNode(fine.grid, [&](const glm::ivec3& at, std::size_t node) {
        for (int p = 0; p < kParents; ++p) {
            const std::size_t parent = parents.of(at, p);
            weight[parent] += kShare;
            coarse.extinctionPerM[parent] += kShare * fine.extinctionPerM[node];
        }
    });
    for (std::size_t i = 0; i < weight.size(); ++i) coarse.extinctionPerM[i] /= weight[i];
    numberActive(coarse);
    const auto degrees = static_cast<std::size_t>(fine.degreeCount);
    forEachNode(fine.grid, [&](const glm::ivec3& at, std::size_t node) {
        if (fine.extinctionPerM[node] <= 0.0f) return;
        const float* from =
            &fine.scatteringPerM[static_cast<std::size_t>(fine.place[node]) * degrees];
        for (int p = 0; p < kParents; ++p) {
            const std::size_t parent = parents.of(at, p);
            float* to = scatteringAt(coarse, parent);
            for (std::size_t l = 0; l < degrees; ++l) to[l] += kShare / weight[parent] * from[l];
        }
    });
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
        const float share = kShare * fine.extinctionPerM[node];
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
                  const LightField& correction, LightField& field) {
    const Parents parents(fine.grid, coarse.grid);
    const auto moments = static_cast<std::size_t>(fine.momentCount);
    forEachNode(fine.grid, [&](const glm::ivec3& at, std::size_t node) {
        for (int p = 0; at.z == 0 && p < 4; ++p) {
            field.groundFlux[node] += correction.groundFlux[parents.of(at, p)] / 4.0f;
        }
        if (fine.place[node] < 0) return;
        const std::size_t to = static_cast<std::size_t>(fine.place[node]) * moments;
        for (int p = 0; p < kParents; ++p) {
            const std::int32_t place = coarse.place[parents.of(at, p)];
            if (place < 0) continue;
            const std::size_t from = static_cast<std::size_t>(place) * moments;
            for (std::size_t q = 0; q < moments; ++q) {
                field.moments[to + q] += kShare * correction.moments[from + q];
            }
        }
    });
}

}  // namespace neph
