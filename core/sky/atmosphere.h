// atmosphere.h: clear air around a spherical Earth: what it leaves of sunlight, and the light that
// it scatters.
//
// After Hillaire 2020 [Hillaire20]: molecules, haze and ozone in spherical layers; light scattered
// once exactly, light scattered more often as if isotropic; part of what haze scatters forwards
// counts as not scattered. Radiances are per unit of the sun's irradiance outside the atmosphere,
// at each wavelength, 1/sr. docs/sky.md
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/sky/spectrum.h"

namespace neph {

inline constexpr double kEarthRadiusM = 6371e3;
inline constexpr double kAtmosphereTopM = 100e3;
/// Of haze: Cornette-Shanks with this g has the asymmetry 0.70 of continental aerosol, average.
/// [Hess98] table 4
inline constexpr double kHazeG = 0.637;
inline constexpr double kHazeAlbedo = 0.9;  ///< [Bruneton17]

struct AtmosphereSpec {
    double visibilityM = 100e3;  ///< at sea level, at 550 nm; contrast 0.02 [Koschmieder24]
    double ozoneDobson = 300.0;
    double groundAlbedo = 0.1;  ///< of the Earth around
    bool operator==(const AtmosphereSpec&) const = default;
};

/// AtmosphereSpec::visibilityM of air whose haze has an extinction of `hazePerM` at 550 nm, with
/// that of molecules.
double visibilityOfHazeM(double hazePerM);

/// Where someone looks, and where the sun stands there.
struct SkyRay {
    double altitudeM = 0.0;       ///< of the eye, above sea level
    double up = 0.0;              ///< sine of the ray's elevation
    double azimuthFromSun = 0.0;  ///< radians
    double sunUp = 0.0;           ///< sine of the sun's elevation, as seen from sea level below
};

/// What a stretch of air adds to the light that comes through it, and what it leaves of it.
struct AirLight {
    Spectrum radiance;
    Spectrum once;  ///< of the radiance, sunlight scattered once
    Spectrum
        byMolecules;  ///< what each scatters of light that comes from all directions alike, per
    Spectrum byHaze;  ///< radiance, without what goes on as if it were not scattered
    Spectrum clear{1.0f};
};

class Atmosphere {
  public:
    explicit Atmosphere(const AtmosphereSpec& spec);
    const AtmosphereSpec& spec() const { return spec_; }
    /// Extinction at sea level, 1/m.
    const Spectrum& moleculesPerM() const { return moleculesPerM_; }
    const Spectrum& hazePerM() const { return hazePerM_; }

    /// What is left of light from outside that arrives from a direction, along bent rays; 0 from
    /// below the horizon.
    Spectrum transmittance(double altitudeM, double up) const;
    /// The same of light from the middle of the sun's disc, as if nothing hid it.
    Spectrum discLight(double altitudeM, double sunUp) const;
    /// The same of sunlight, of whose disc the horizon may hide a part; `sunUp` as of SkyRay.
    Spectrum sunlight(double altitudeM, double sunUp) const;

    /// All of the air along a ray, to the ground or to space.
    AirLight along(const SkyRay& ray) const;
    /// Of the air up to each of some distances, which increase, m. Beyond the top there is no more,
    /// and beyond the ground none after the first of them there: up to that air goes on as dense as
    /// at sea level, so that light can be interpolated up to the ground.
    void along(const SkyRay& ray, std::span<const double> distancesM, std::span<AirLight> to) const;

  private:
    /// What air at an altitude does to light, 1/m.
    struct Local {
        Spectrum molecules, haze;  ///< scattering
        Spectrum extinction;
    };
    struct Path;
    struct Place;
    struct Phases;
    struct Sum;
    Local localAt(double altitudeM) const;
    Spectrum depthOf(const glm::dvec3& columnsM, double forward = 0.0) const;
    Spectrum sunlightOf(double altitudeM, double trueUp, double forward) const;
    Spectrum manyTimes(double altitudeM, double trueUp) const;
    static int partsOf(const Path& path, double fromM, double toM);
    void add(const Place& place, double lengthM, const Phases& phases, Sum& sum) const;
    Spectrum manyTimesAt(double altitudeM, double trueUp) const;

    AtmosphereSpec spec_;
    Spectrum moleculesPerM_, hazePerM_, ozonePerM_;  ///< extinction where there is most of each
    std::vector<Spectrum> manyTimes_;                ///< by altitude and the sun's true elevation
};

}  // namespace neph
