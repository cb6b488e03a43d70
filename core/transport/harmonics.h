// harmonics.h: the functions of direction in which the solver of multiple scattering keeps
// radiance.
//
// Real orthonormal spherical harmonics to l = 2 without the sign of Condon and Shortley, then zonal
// ones of l = 3 and 4 about the direction in which sunlight travels:
//   0: 1 | 1: y, 2: z, 3: x | 4: xy, 5: yz, 6: 3z²-1, 7: xz, 8: x²-y² | 9: P_3, 10: P_4
// Directions are unit vectors in which light travels, x east, y north, z up.
#pragma once
#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace neph {

inline constexpr int kBroadMoments = 9;     ///< l = 0 ... 2
inline constexpr int kAlignedMoments = 11;  ///< the same and l = 3, 4 about the sun
inline constexpr int kBroadDegrees = 3;
inline constexpr int kAlignedDegrees = 5;

/// Values of all kAlignedMoments functions; who needs kBroadMoments ignores the rest.
using Harmonics = std::array<float, kAlignedMoments>;

/// `sunTravel` is the direction in which sunlight travels.
Harmonics harmonicsAt(const glm::dvec3& travel, const glm::dvec3& sunTravel);

/// Degree l of a function by its place.
constexpr int degreeOf(int place) {
    return place == 0 ? 0 : place < 4 ? 1 : place < kBroadMoments ? 2 : place - 6;
}

/// Legendre polynomials P_0 ... P_(count - 1).
template <std::size_t count>
std::array<double, count> legendreAt(double x) {
    std::array<double, count> value{1.0, x};
    for (std::size_t l = 2; l < count; ++l) {
        const auto n = static_cast<double>(l);
        value[l] = ((2.0 * n - 1.0) * x * value[l - 1] - (n - 1.0) * value[l - 2]) / n;
    }
    return value;
}

}  // namespace neph
