// grid_loops.h: visits to all nodes of a grid, and their neighbours.
#pragma once
#include <array>
#include <cstddef>
#include <glm/glm.hpp>

#include "core/transport/transport_level.h"

namespace neph {

/// `visit(node, index)`, x fastest.
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
inline std::array<int, 3> beside(const TransportGrid& grid, int axis, int at) {
    const int n = grid.nodes[axis];
    if (grid.periodic(axis)) return {(at + n - 1) % n, at, (at + 1) % n};
    return {at - 1, at, at + 1 < n ? at + 1 : -1};
}

/// How many times the volume around `node` goes into that of a node inside: 2 for each open side
/// on which it lies.
inline float timesCut(const TransportGrid& grid, const glm::ivec3& node) {
    float times = 1.0f;
    for (int axis = 0; axis < 3; ++axis) {
        const bool last = node[axis] == 0 || node[axis] == grid.nodes[axis] - 1;
        if (last && !grid.periodic(axis)) times *= 2.0f;
    }
    return times;
}

}  // namespace neph
