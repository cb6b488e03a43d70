// box.h: a part of a field: x, y, z, half-open.
#pragma once
#include <array>
#include <cstddef>
#include <functional>

namespace les {

/// Called between pieces with the fraction done, 0 to 1; throws Cancelled to stop.
using Tick = std::function<void(double)>;

/// Cells [lower, upper) of a field.
struct Box {
    std::array<std::size_t, 3> lower{}, upper{};
    std::size_t length(std::size_t axis) const { return upper[axis] - lower[axis]; }
    std::size_t plane() const { return length(0) * length(1); }
    std::size_t count() const { return plane() * length(2); }
};

}  // namespace les
