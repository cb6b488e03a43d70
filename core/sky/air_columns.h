// air_columns.h: how much air light passes on its way in from space.
#pragma once
#include <glm/glm.hpp>

namespace neph {

/// Scale height of molecules: of all the air there is, if it were as dense as at the ground.
inline constexpr double kMoleculesHeightM = 8400.0;
/// Scale height of haze. [Bruneton17]
inline constexpr double kHazeHeightM = 1200.0;

/// Of molecules, haze and ozone: shares of their largest density.
glm::dvec3 airDensity(double altitudeM);

/// Sine of the elevation of the horizon, with a bare sphere for the Earth.
double horizonUp(double altitudeM);

/// Along a ray from space that does not meet the ground: metres of molecules, haze and ozone at
/// their largest density. From a table; relative error below 1e-3.
glm::dvec3 airColumnsM(double altitudeM, double up);

/// The same by integration, without the table.
glm::dvec3 integratedColumnsM(double altitudeM, double up);

}  // namespace neph
