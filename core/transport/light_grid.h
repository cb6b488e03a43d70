// light_grid.h: where among the voxels of a medium its light is computed.
#pragma once
#include <glm/glm.hpp>

#include "core/grid/boxes.h"
#include "core/grid/grid.h"

namespace neph {

/// Node n lies at the centre of voxel `firstVoxel + n * stride`, which may be beyond the medium: a
/// node at least lies around what is occupied, and the lowest ones on the ground or, where that is
/// far below, nearer.
struct LightGrid {
    glm::ivec3 nodes{0};
    glm::ivec3 firstVoxel{0};
    glm::ivec3 stride{1};
    glm::dvec3 lowerM{0.0};  ///< node 0, in grid space
    glm::dvec3 spacingM{1.0};

    glm::dvec3 extentM() const { return glm::dvec3(nodes) * spacingM; }
    bool operator==(const LightGrid&) const = default;
};

/// The finest of at most about `mostNodes` nodes, whose spacings are multiples of the voxels'.
/// `occupied` is in grid space.
LightGrid chooseLightGrid(const RegularGrid& medium, const BoxM& occupied, int mostNodes);

}  // namespace neph
