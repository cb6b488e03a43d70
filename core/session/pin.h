// pin.h: a place of the storm that is kept.
#pragma once
#include <glm/glm.hpp>
#include <string>

namespace neph {

inline constexpr std::size_t kMaxPins = 200;

/// In world space, metres, which moves with a grid that moves.
struct Pin {
    std::string label;
    glm::dvec3 positionM{0.0};
    bool operator==(const Pin&) const = default;
};

}  // namespace neph
