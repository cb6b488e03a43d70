// air_profile.h: how dense air is by altitude, and how it bends light.
//
// In layers around a sphere a ray keeps n r cos e: refractive index, radius and the cosine of its
// elevation. Where radii are scaled by n, rays are therefore straight lines. `raised` stands for
// such a scaled altitude: n r less its value at sea level.
#pragma once
#include <glm/glm.hpp>

namespace neph {

/// The column of molecules above the sea, as if all of it were as dense as there. [USSA76]
inline constexpr double kMoleculesHeightM = 8455.0;

/// Scale height of haze. [Bruneton17]
inline constexpr double kHazeHeightM = 1200.0;

/// Of molecules [USSA76], haze and ozone: shares of their largest density.
glm::dvec3 airDensity(double altitudeM);

/// Refractive index of air at 550 nm less 1, in proportion to the density of molecules.
double refractivity(double altitudeM);

/// n r of an altitude less that of the sea, m; increases with altitude, and is less than it.
double raisedOfAltitude(double altitudeM);
/// n r at sea level, m.
double raisedEarthRadiusM();

/// What a ray passes per metre of the straight line that it is in scaled radii.
struct BentAir {
    glm::dvec3 columns{0.0};   ///< metres of molecules, haze and ozone at their largest density
    double bendingPerM = 0.0;  ///< of a level ray, radians
};
BentAir bentAirAt(double raisedM);

}  // namespace neph
