// sky_references.h: what is published and computed of clear skies. docs/validation.md
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace neph::validate {

/// Sunlight at sea level. Air masses are of the table of [KastenYoung89]. Shares are of the
/// illuminance outside: the sum over the spectrum of the sun [Bruneton17] in steps of 1 nm, weighed
/// by V(lambda) [Wyman13], through so much air of the optical depth of [Bodhaine99].
struct DirectSun {
    double elevationDeg, airMass, luminousShare;
};
inline constexpr std::array kDirectSun{
    DirectSun{60.0, 1.1540, 0.89497}, DirectSun{20.0, 2.9032, 0.75820},
    DirectSun{5.0, 10.306, 0.38640}, DirectSun{1.0, 26.31, 0.10146}};

/// [KastenYoung89] eq. 3
double relativeAirMass(double elevationDeg);
/// Optical depth of pure air for the eye, per air mass. [DarulaKittler02] eq. 17
double luminousExtinction(double airMass);

/// Of the dip of the horizon, per square root of metres: 1.76' of the Nautical Almanac.
inline constexpr double kAlmanacDipDeg = 1.76 / 60.0;

/// A type of [CIES011], and its coefficients A1 ... E in [DarulaKittler02] table 2.
struct StandardSky {
    int number;
    double a, b;     ///< gradation
    double c, d, e;  ///< indicatrix
    double zenithA1, zenithA2, zenithB, zenithC, zenithD, zenithE;
};
inline constexpr std::array kStandardSkies{
    StandardSky{11, -1.0, -0.55, 10.0, -3.0, 0.45, 1.440, -0.750, 24.41, 4.60, 0.72, 20.76},
    StandardSky{12, -1.0, -0.32, 10.0, -3.0, 0.45, 1.036, 0.710, 23.00, 4.43, 0.74, 18.52},
    StandardSky{13, -1.0, -0.32, 16.0, -3.0, 0.30, 1.244, -0.840, 27.45, 4.61, 0.76, 16.59},
    StandardSky{14, -1.0, -0.15, 16.0, -3.0, 0.30, 0.881, 0.453, 25.54, 4.40, 0.79, 14.56}};

/// Luminance over that of the zenith. [CIES011]
double relativeLuminance(const StandardSky& type, const glm::dvec3& towards,
                         const glm::dvec3& towardsSun);
/// Luminance of the zenith, kcd/m²: by [DarulaKittler02] eq. 12, from the illuminance of the sky on
/// level ground, and by eq. 13, from the luminous turbidity.
struct ZenithKcdPerM2 {
    double fromDiffuse, fromTurbidity;
    double mean() const { return 0.5 * (fromDiffuse + fromTurbidity); }
};
ZenithKcdPerM2 zenithOf(const StandardSky& type, double sunDeg, double diffuseKlx,
                        double turbidity);

/// Radiance of the sky at 560 nm per irradiance of the sun outside, 1/sr, over ground of albedo
/// 0.2, by adding-doubling: 24 Gauss nodes per hemisphere, 37 Fourier components of azimuth, 22
/// level homogeneous layers of the molecules, haze and ozone of core/sky.
struct ExactRadiance {
    double sunDeg, elevationDeg, azimuthDeg, radiance;
};
struct ExactSky {
    double visibilityM;
    std::vector<ExactRadiance> radiances;
};
std::vector<ExactSky> exactSkies();

}  // namespace neph::validate
