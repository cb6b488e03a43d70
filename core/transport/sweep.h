// sweep.h: carries light through the medium along each direction of a set, and adds up the moments.
//
// Short characteristics: slices of nodes across the axis that a direction crosses fastest, each
// node fed from the point upwind of it in the slice before.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "core/transport/directions.h"
#include "core/transport/transport_level.h"

namespace neph {

struct SweepInput {
    const TransportLevel* level = nullptr;
    const LightField* field = nullptr;  ///< what is scattered, besides the beam
    const float* beam = nullptr;        ///< irradiance across the beam at every node, or null
    glm::dvec3 sunTravel{0.0};
    SkyLight sky{0.0, 0.0};             ///< enters from above
    float farGroundRadiance = 0.0f;     ///< enters upwards through open sides
    std::vector<float> groundRadiance;  ///< leaves the ground
    bool cubic = true;                  ///< interpolation upwind; linear if not
};

/// What a sweep adds up.
struct Swept {
    LightField field;  ///< that one scattering of the input and its boundaries give
    // Of active nodes; empty unless the level is thick.
    std::vector<float> excess;    ///< radiance over source, over all directions and depths around
    std::vector<float> exchange;  ///< how much of the excess a source of the node alone would lose
};

/// What directions leave beside the moments.
struct SweptEnds {
    std::vector<float> groundFlux, excess, exchange;  ///< as LightField and Swept have them
};

/// Directions are shared out over `threads`; the sum depends on their number only by rounding. On a
/// thick level they are such that the opposite of each is one too.
Swept swept(const SweepInput& input, const LightDirections& directions, int threads);

/// What a sweep of a level holds while it lasts, its result included.
std::size_t sweptBytes(const TransportLevel& level);

}  // namespace neph
