// look.h: what an image shows: every tunable that presets share.
//
// Plain values; the rows of `lookTable()` in core/look/parameter.h say what they are. SI units. How
// finely an image is computed stands apart, in core/look/sampling.h.
#pragma once
#include <array>
#include <cstddef>
#include <glm/glm.hpp>

#include "core/grid/species.h"
#include "core/look/engines.h"
#include "core/optics/noise.h"
#include "core/optics/phase.h"

namespace neph {

/// Engines that do not know `full` take it for `translucent`.
enum class Transport : int { lowAlbedo, translucent, full };
enum class PhaseMode : int { uniform, perField };
enum class ExtinctionMode : int { physical, equal };
/// How extinction follows from a radius that comes from the model: large spheres, or the fits of
/// the radiation code that WRF runs with.
enum class RadiationOptics : int { geometric, wrfRrtmg };
/// Whether mixing scales hold as they are, or for cells of kLookCellM: see mixingScaleAt().
enum class MixingRule : int { asGiven, byCell };
enum class ColourMode : int { natural, fields };
enum class LightForm : int { printed, consistent };
/// What is beside the volume, for light and eye: nothing, or the volume again and again in x and y.
enum class DomainSides : int { open, periodic };
enum class PhaseDisplay : int { linear, logarithmic, physical };
/// Two colours, or the air of the Earth. docs/sky.md
enum class SkyModel : int { gradient, atmosphere };
/// How thick haze is: by the look's visibility, by the humidity of the data's lowest air, or by the
/// aerosol in it.
enum class Haze : int { fixed, humidity, aerosol };
/// What lights the scene: the sun, or the moon in its place.
enum class LightBody : int { sun, moon };
/// How paths of the reference meet the air within the grid. docs/sky.md
enum class ReferenceAir : int { traced, tables };
/// What the place of the sun follows from.
enum class SunSource : int { angles, date };
enum class ToneMap : int { linear, filmic, agx, reflectance };
/// What the ground is: of one colour, or a pattern upon it; or the sea, whose colour is known.
enum class GroundSurface : int { plain, fields, sea };
/// What light shows as white: daylight, or what falls on the clouds.
enum class WhiteBalance : int { daylight, sun };

/// Where the size of a field's particles comes from. docs/physics.md §7
enum class RadiusSource : int { constant, file, number, scheme };

struct SpeciesLook {
    bool visible = true;
    float mixingScale = 1.0f;
    RadiusSource radiusSource = RadiusSource::constant;
    float effectiveRadiusM = 10e-6f;
    float densityKgPerM3 = 1000.0f;
    float albedo = 1.0f;
    glm::vec3 colour{1.0f};
    PhaseSpec phase;
    float noiseAmount = 0.0f;
    float noiseScaleCells = 8.0f;  ///< of the data's native horizontal cells
    NoiseCharacter noiseCharacter = NoiseCharacter::billow;
    bool operator==(const SpeciesLook&) const = default;
};

/// Native cell of the storm that looks are tuned on; parameters that adapt to the cell size are
/// the same there either way.
inline constexpr double kLookCellM = 1000.0;

/// The exposure value at ISO 100 that shows the radiance of isotropic scatter in full sunlight as
/// white, 1: a luminance of 1.2 cd/m² times 2^EV100 is white [Lagarde14].
inline constexpr float kUnitEv100 = 13.1f;

/// The defaults written here are the defaults everywhere: tuned by eye on the bundled storm where
/// no source is named. What the rows' help cites is not repeated here.
struct Look {
    Look();

    Transport transport = Transport::full;
    PhaseMode phaseMode = PhaseMode::perField;
    bool noise = true;
    ExtinctionMode extinction = ExtinctionMode::physical;
    RadiationOptics radiationOptics = RadiationOptics::geometric;
    MixingRule mixing = MixingRule::asGiven;
    ColourMode colour = ColourMode::natural;

    DomainSides domainSides = DomainSides::open;
    LightForm lightForm = LightForm::printed;
    float forwardAngleDeg = 20.0f;  ///< half of it, 10°, holds 90 % in [Riley03] fig. 7
    float forwardG = 0.979f;
    PhaseDisplay phaseDisplay = PhaseDisplay::physical;
    float phaseTruncationDeg = 10.0f;
    PhaseSpec uniformPhase;
    float equalExtinctionM2PerKg = 10.0f;

    SunSource sunSource = SunSource::angles;
    float sunAzimuthDeg = 225.0f;
    float sunElevationDeg = 35.0f;
    /// Where data state no place or date: a spring afternoon over the southern plains.
    float sunLatitudeDeg = 35.0f, sunLongitudeDeg = -97.5f;
    int sunDay = 141;       ///< of a leap year: 20 May
    float sunHour = 22.0f;  ///< UTC
    LightBody sunBody = LightBody::sun;
    float moonPhaseDeg = 0.0f, moonLimbDeg = 90.0f;
    float sunIntensity = 1.0f;
    bool sunDisc = true;
    glm::vec3 sunColour{1.0f, 0.96f, 0.90f};

    SkyModel skyModel = SkyModel::gradient;
    Haze haze = Haze::fixed;
    float visibilityM = 100e3f;
    float ozoneDobson = 300.0f;
    ReferenceAir referenceAir = ReferenceAir::traced;
    glm::vec3 skyZenith{0.03f, 0.09f, 0.26f};
    glm::vec3 skyHorizon{0.20f, 0.30f, 0.44f};
    float skyIntensity = 1.0f;
    float skylight = 0.25f;
    bool groundVisible = true;
    GroundSurface groundSurface = GroundSurface::fields;
    glm::vec3 groundColour{0.13f, 0.12f, 0.065f};

    Engine engine{};
    int planes = 256;  ///< of the slicing engine; they decide the brightness of its printed form
    float exposureEv = 0.4f;
    bool autoExposure = true;
    float ev100 = kUnitEv100;  ///< where exposure does not follow the light
    WhiteBalance whiteBalance = WhiteBalance::daylight;
    float glare = 0.01f;  ///< share of light that strays in the lens
    ToneMap toneMap = ToneMap::filmic;

    std::array<SpeciesLook, kSpeciesCount> species;

    SpeciesLook& of(Species s) { return species[static_cast<std::size_t>(s)]; }
    const SpeciesLook& of(Species s) const { return species[static_cast<std::size_t>(s)]; }
    bool operator==(const Look&) const = default;
};

/// Whether light is followed through all its scatterings: Transport::full, of an engine that knows
/// it.
bool scattersOften(const Look& look);

/// Whether an image of it is a radiance, not a display of phase functions by another scale.
bool showsRadiance(const Look& look);

/// Radiance of the ground in full light, linear RGB: that of the look, or of the sea.
glm::vec3 shownGroundColour(const Look& look);

/// Albedo of the ground, linear RGB: of a Lambert surface with the radiance that the look gives it
/// in full light.
glm::vec3 groundAlbedo(const Look& look);

/// Whether light and eye meet the volume again beyond its sides: DomainSides::periodic, of an
/// engine that knows it.
bool sidesRepeat(const Look& look);

/// Between periodic sides light from a sun on the horizon would never leave; it stands at least so
/// high, or so low. Tuned: clouds of 4 km then have shadows of 230 km.
inline constexpr float kLowestPeriodicSunDeg = 1.0f;

}  // namespace neph
