// box.h: a part of a field: x, y, z, half-open.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace shared {

/// Cells [lower, upper) of a field.
struct Box {
    std::array<std::size_t, 3> lower{}, upper{};
    std::size_t length(std::size_t axis) const { return upper[axis] - lower[axis]; }
    std::size_t plane() const { return length(0) * length(1); }
    std::size_t count() const { return plane() * length(2); }
};

/// Puts the values of a box into those of one that it lies in, x fastest.
inline void putInto(const Box& whole, std::span<float> values, const Box& part,
                    std::span<const float> ofPart) {
    for (std::size_t row = 0; row < part.length(1) * part.length(2); ++row) {
        const std::size_t y = part.lower[1] - whole.lower[1] + row % part.length(1);
        const std::size_t z = part.lower[2] - whole.lower[2] + row / part.length(1);
        const std::size_t to =
            (z * whole.length(1) + y) * whole.length(0) + part.lower[0] - whole.lower[0];
        std::ranges::copy(ofPart.subspan(row * part.length(0), part.length(0)),
                          values.begin() + static_cast<std::ptrdiff_t>(to));
    }
}

}  // namespace shared
