// tiles.cpp: as wide as can be, then as high as there is room for.
#include "app/render/frame/tiles.h"

#include <algorithm>

namespace neph::render {

glm::ivec2 tileSize(glm::ivec2 sizePx, int supersample, int mostSidePx, std::size_t mostRays) {
    const auto rays = static_cast<std::size_t>(supersample);
    glm::ivec2 tile = glm::min(sizePx, glm::ivec2(std::max(1, mostSidePx / supersample)));
    tile.x = static_cast<int>(std::min(static_cast<std::size_t>(tile.x),
                                       std::max<std::size_t>(1, mostRays / (rays * rays))));
    // A band of tiles is held on the host: the whole width counts.
    const std::size_t across = std::max(static_cast<std::size_t>(tile.x) * rays * rays,
                                        static_cast<std::size_t>(sizePx.x));
    tile.y = static_cast<int>(
        std::min(static_cast<std::size_t>(tile.y), std::max<std::size_t>(1, mostRays / across)));
    return tile;
}

}  // namespace neph::render
