// air_columns.h: how much air light passes on its way in from space, and how much it is bent.
//
// An elevation is apparent, as light arrives, or true, as it would without air.
#pragma once
#include <glm/glm.hpp>

#include "core/sky/air_profile.h"

namespace neph {

/// Sine of the elevation of the horizon, with a bare sphere for the Earth.
double horizonUp(double altitudeM);
/// The same with air, which lowers it less: light from there is bent.
double apparentHorizonUp(double altitudeM);

/// A ray from space that does not meet the ground.
struct BentRay {
    glm::dvec3 columnsM{0.0};  ///< metres of molecules, haze and ozone at their largest density
    double bending = 0.0;      ///< radians: apparent less true elevation
};
/// By integration; `up` is the sine of the apparent elevation. Below the horizon the ray of the
/// horizon.
BentRay bentRay(double altitudeM, double up);

/// Sine of the true elevation of a sun that is seen from sea level at an elevation whose sine is
/// `apparentUp`. Below the horizon, where none is seen, the inverse of `refractionDeg`.
double trueSunUp(double apparentUp);
/// Sine of the apparent elevation, at an altitude, of a sun with that true elevation; where the
/// Earth hides it, as far from the horizon as without air.
double apparentSunUp(double altitudeM, double trueUp);

/// What light of a sun passes that stands at a true elevation.
struct SunAir {
    glm::dvec3 columnsM{0.0};  ///< as of BentRay
    double lowestUp = 0.0;     ///< sine of the true elevation of what is seen at the horizon
};
/// From a table, within 1 % of columns of 100 m and more. Of a hidden sun those of the horizon.
SunAir sunAir(double altitudeM, double trueUp);

}  // namespace neph
