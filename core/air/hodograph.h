// hodograph.h: what the change of wind with height tells of storms. Heights are above the ground;
// winds are along the grid's x and y, m/s. The sounding has wind.
#pragma once
#include <glm/glm.hpp>

#include "core/air/sounding.h"

namespace neph {

/// The wind at `topM` less that at the ground.
glm::dvec2 bulkShearMPerS(const Sounding& sounding, double topM);

/// Mean over height, by pressure.
glm::dvec2 meanWindMPerS(const Sounding& sounding, double fromM, double toM);

/// How supercells that turn right and left move, and the mean wind of the lowest 6 km. [Bunkers00]
struct StormMotion {
    glm::dvec2 rightMPerS{0.0}, leftMPerS{0.0}, meanMPerS{0.0};
};
StormMotion stormMotionOf(const Sounding& sounding);

/// Storm-relative helicity of the lowest `topM`, m²/s²: minus twice the area that the hodograph
/// sweeps around the storm's motion [Davies90].
double stormRelativeHelicity(const Sounding& sounding, double topM, glm::dvec2 motionMPerS);

}  // namespace neph
