// image.h: images in memory; row 0 is the top row.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace neph {

/// Linear RGBA float.
struct ImageF {
    glm::ivec2 size{0};
    std::vector<glm::vec4> pixels;
};

/// sRGB RGBA, 8 bits.
struct Image8 {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgba;
};

}  // namespace neph
