// tiles.h: the parts that an image is drawn in where it is larger than a texture may be, or than
// what is to be held at once.
#pragma once
#include <cstddef>
#include <glm/glm.hpp>

namespace neph::render {

/// Rays that are held at once: 16 bytes each on the GPU, twice that while slicing. A 3840 x 2160
/// image is one tile.
inline constexpr std::size_t kMostTileRays = std::size_t{1} << 23;

/// Size of the tiles of an image where no more than `mostSidePx` rays fit a texture's side: few,
/// of no more than `mostRays` each, a row of them of no more pixels than that. At least one pixel.
glm::ivec2 tileSize(glm::ivec2 sizePx, int supersample, int mostSidePx, std::size_t mostRays);

}  // namespace neph::render
