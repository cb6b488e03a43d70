// brick_map.h: which bricks of a medium are empty, and how far it is to the next that is not.
#pragma once
#include "app/gl/objects.h"
#include "core/grid/boxes.h"
#include "core/grid/grid.h"
#include "core/grid/species.h"

namespace neph::render {

#include "shaders/shared/medium_layout.glsl"

struct BrickMap {
    /// R8UI a brick: Chebyshev distance to the nearest occupied brick, 0 in one.
    gl::Texture map;
    BoxM occupied;  ///< in grid space; empty (lower == upper) when nothing is there
    glm::dvec3 brickM{1.0};

    bool empty() const { return occupied.lowerM == occupied.upperM; }
};

/// Chebyshev distance of each brick to the nearest whose value is above `threshold`, up to 255; 0
/// where its own is.
Array3<std::uint8_t> emptyDistances(const Array3f& bricks, float threshold);

/// `maximumPerM`: the largest extinction that interpolation can give in each brick. Bricks that
/// would not give a ray through the whole domain `invisibleDepth` are empty.
BrickMap mapBricks(const Array3f& maximumPerM, const RegularGrid& grid, double invisibleDepth);

/// An R32F texture in the machine's memory; waits for it.
Array3f readBack(const gl::Texture& texture);

inline glm::ivec3 brickCount(glm::ivec3 voxels) {
    return (voxels + kBrickVoxels - 1) / kBrickVoxels;
}

}  // namespace neph::render
