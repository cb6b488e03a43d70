// boxes.h: axis-aligned half-open boxes, one type per space.
#pragma once
#include <glm/glm.hpp>

namespace neph {

/// Metres, in world space (grid.h) unless stated otherwise.
struct BoxM {
    glm::dvec3 lowerM{0.0};
    glm::dvec3 upperM{0.0};
    glm::dvec3 sizeM() const { return upperM - lowerM; }
    bool operator==(const BoxM&) const = default;
};

/// Cells of a native or regular grid.
struct CellBox {
    glm::ivec3 lower{0};
    glm::ivec3 upper{0};
    glm::ivec3 size() const { return upper - lower; }
    bool operator==(const CellBox&) const = default;
};

/// Pixels of an image or a framebuffer, row 0 at the bottom.
struct PixelBox {
    glm::ivec2 lower{0};
    glm::ivec2 upper{0};
    glm::ivec2 size() const { return upper - lower; }
    bool operator==(const PixelBox&) const = default;
};

}  // namespace neph
