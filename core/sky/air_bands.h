// air_bands.h: the air near the ground in the three bands of linear sRGB, for paths of light that
// meet molecules and haze as they meet particles.
#pragma once
#include <glm/glm.hpp>

#include "core/sky/atmosphere.h"

namespace neph {

/// Both thin out with height, each by its scale height.
struct AirBands {
    glm::dvec3 moleculesPerM{0.0}, hazePerM{0.0};  ///< extinction at sea level
    double moleculesHeightM = 1.0, hazeHeightM = 1.0;
    double hazeAlbedo = 1.0;  ///< molecules absorb nothing
    bool operator==(const AirBands&) const = default;
};

/// Extinctions by which white sunlight keeps its exact colour through so much of molecules alone,
/// or haze alone, that a depth of 1/2 is reached at 560 nm. Those of thin and of thick air are
/// within 2 % of them. docs/sky.md
AirBands airBandsOf(const Atmosphere& air);

}  // namespace neph
