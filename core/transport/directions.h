// directions.h: the sets of directions along which light is swept, drawn for each cycle.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace neph {

struct LightDirection {
    glm::dvec3 travel{0.0};  ///< unit vector in which light travels
    double weightSr = 0.0;   ///< the weights of a set sum to 4 pi
};

using LightDirections = std::vector<LightDirection>;

/// Draws the sets; the same seed gives the same ones in turn on every platform. Where they start is
/// random, and each keeps as far from those before as it can, so that their average soon settles.
/// The opposite of each direction is in its set too.
class DirectionSource {
  public:
    explicit DirectionSource(std::uint64_t seed);

    /// The 12 corners of an icosahedron, turned at random: integrates l <= 5.
    LightDirections turnedIcosahedron();
    /// Rings about `axis` at the points of Gauss and Legendre, 8, 9, 10 and 11 in turn, each with
    /// azimuths of its own: integrates zonal functions of l <= 15.
    LightDirections rings(const glm::dvec3& axis);

  private:
    static constexpr std::size_t kMostStarts = 6;

    /// The value of this turn in sequence `i`, 0 ... 1, which goes on by `step`.
    double spread(std::size_t i, double step) const;

    std::array<double, kMostStarts> starts_{};  ///< of the sequences
    int turn_ = 0;
};

}  // namespace neph
