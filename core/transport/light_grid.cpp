// light_grid.cpp: widens the smallest spacing until there are few enough nodes.
#include "core/transport/light_grid.h"

#include <algorithm>
#include <cmath>

namespace neph {
namespace {

constexpr int kMostNodesBelow = 32;  // of the medium, down to the ground

/// Nodes along a periodic axis, no closer than so many voxels: coarser grids need even numbers.
int repeatingNodes(int voxels, int stride) {
    const int most = voxels / stride;
    return most >= 8 ? most - most % 4 : std::max(2, most - most % 2);
}

void divideWidth(const RegularGrid& medium, int axis, LightGrid& grid) {
    constexpr double kRounding = 1e-9;
    const int voxels = medium.size[axis];
    const int nodes = repeatingNodes(voxels, grid.stride[axis]);
    const double perNode = static_cast<double>(voxels) / nodes;
    grid.nodes[axis] = nodes;
    grid.stride[axis] = static_cast<int>(std::ceil(perNode - kRounding));
    grid.spacingM[axis] = perNode * medium.spacingM[axis];
    grid.lowerM[axis] = 0.5 * grid.spacingM[axis];
}

LightGrid gridOf(const RegularGrid& medium, const BoxM& occupied, glm::ivec3 stride,
                 bool periodicSides) {
    LightGrid grid;
    grid.stride = stride;
    grid.spacingM = glm::dvec3(stride) * medium.spacingM;
    grid.periodicSides = periodicSides;
    for (int axis = 0; axis < 3; ++axis) {
        if (periodicSides && axis < 2) {
            divideWidth(medium, axis, grid);
            continue;
        }
        const double voxelM = medium.spacingM[axis];
        const int first = static_cast<int>(std::floor(occupied.lowerM[axis] / voxelM));
        const int last = static_cast<int>(std::ceil(occupied.upperM[axis] / voxelM)) - 1;
        int from = first - stride[axis];
        if (axis == 2) {
            const double heightM = medium.originM.z + (first + 0.5) * voxelM;
            const double below = std::round(std::max(0.0, heightM) / grid.spacingM.z);
            // The plane of the lowest nodes stands for the ground.
            from = first - stride.z * static_cast<int>(std::min<double>(
                                          below, first / stride.z + kMostNodesBelow));
        }
        grid.lowerM[axis] = (from + 0.5) * voxelM;
        grid.nodes[axis] = std::max(2, (last - from + stride[axis] - 1) / stride[axis] + 2);
    }
    return grid;
}

}  // namespace

LightGrid chooseLightGrid(const RegularGrid& medium, const BoxM& occupied, int mostNodes,
                          bool periodicSides) {
    glm::ivec3 stride(1);
    while (true) {
        const LightGrid grid = gridOf(medium, occupied, stride, periodicSides);
        const double count = static_cast<double>(grid.nodes.x) * grid.nodes.y * grid.nodes.z;
        const int most = std::max({grid.nodes.x, grid.nodes.y, grid.nodes.z});
        if (count <= mostNodes || most <= 3) return grid;
        // The axis on which nodes lie closest, unless it has hardly any.
        int widened = -1;
        for (int axis = 0; axis < 3; ++axis) {
            if (grid.nodes[axis] <= 3) continue;
            if (widened < 0 || grid.spacingM[axis] < grid.spacingM[widened]) widened = axis;
        }
        ++stride[widened];
    }
}

}  // namespace neph
