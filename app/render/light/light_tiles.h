// light_tiles.h: which parts of each layer of light pass through anything.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "app/gl/objects.h"
#include "app/render/light/slice_plan.h"

namespace neph::render {

#include "shaders/shared/light_layout.glsl"

/// Tiles of the slices of one batch, one slice after the other.
struct LightTiles {
    std::vector<glm::ivec2> tiles;
    std::vector<int> firstOf;  ///< of each slice of the batch, and the end
};

/// `blocks`: all that may hold anything, each `blockM` large.
LightTiles tilesOf(const std::vector<glm::ivec3>& blocks, glm::dvec3 blockM, const SlicePlan& plan,
                   int firstSlice, int slices);

}  // namespace neph::render
