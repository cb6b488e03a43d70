// light_grid.h: where among the voxels of a medium its light is computed.
#pragma once
#include <glm/glm.hpp>

#include "core/grid/boxes.h"
#include "core/grid/grid.h"

namespace neph {

/// Nodes lie at the centres of voxels, which may be beyond the medium: a node at least lies around
/// what is occupied, and the lowest ones on the ground or, where that is far below, nearer.
/// Between periodic sides they divide the whole width evenly, each in the middle of its share.
struct LightGrid {
    glm::ivec3 nodes{0};
    glm::ivec3 stride{1};    ///< voxels from node to node; between periodic sides rounded up
    glm::dvec3 lowerM{0.0};  ///< node 0, in grid space
    glm::dvec3 spacingM{1.0};
    bool periodicSides = false;

    /// Nodes that textures hold: of periodic sides also those beside, which they repeat.
    glm::ivec3 held() const { return nodes + 2 * repeated(); }
    /// How many of them lie before node 0 along each axis.
    glm::ivec3 repeated() const { return {periodicSides, periodicSides, 0}; }
    bool operator==(const LightGrid&) const = default;
};

/// The finest of at most about `mostNodes` nodes, whose spacings are multiples of the voxels'.
/// `occupied` is in grid space. Between periodic sides spacings are what divides the width into a
/// number of nodes that can be halved.
LightGrid chooseLightGrid(const RegularGrid& medium, const BoxM& occupied, int mostNodes,
                          bool periodicSides);

}  // namespace neph
