// look.h: every tunable of the picture, declared once.
//
// `Look` holds values; the rows of `lookTable()` say what they are. Widgets, tooltips, reset, undo,
// presets, `--set`, what is recomputed and the parameter reference all come from the rows. SI
// units; panels multiply by `displayScale`.
#pragma once
#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/grid/species.h"
#include "core/look/engines.h"
#include "core/optics/noise.h"
#include "core/optics/phase.h"

namespace neph {

enum class Transport : int { lowAlbedo, translucent };
enum class PhaseMode : int { uniform, perField };
enum class ExtinctionMode : int { physical, equal };
/// How extinction follows from a radius that comes from the model: large spheres, or the fits of
/// the radiation code that WRF runs with.
enum class RadiationOptics : int { geometric, wrfRrtmg };
enum class ColourMode : int { natural, fields };
enum class LightForm : int { printed, consistent };
enum class PhaseDisplay : int { linear, logarithmic, physical };
enum class ToneMap : int { linear, filmic };

/// Where the size of a field's particles comes from. docs/physics.md §7
enum class RadiusSource : int { constant, file, number, scheme };

/// What must be recomputed when a parameter changes; each stage implies those after it. `data`: the
/// volume is read again.
enum class Stage : int { data, medium, light, eye, resolve };

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
    float noiseScaleM = 8000.0f;
    NoiseCharacter noiseCharacter = NoiseCharacter::billow;
    bool operator==(const SpeciesLook&) const = default;
};

/// The defaults written here are the defaults everywhere: tuned by eye on the bundled storm where
/// no source is named. What the rows' help cites is not repeated here.
struct Look {
    Look();

    Transport transport = Transport::translucent;
    PhaseMode phaseMode = PhaseMode::perField;
    bool noise = true;
    ExtinctionMode extinction = ExtinctionMode::physical;
    RadiationOptics radiationOptics = RadiationOptics::geometric;
    ColourMode colour = ColourMode::natural;

    LightForm lightForm = LightForm::printed;
    float forwardAngleDeg = 20.0f;  ///< half of it, 10°, holds 90 % in [Riley03] fig. 7
    float forwardG = 0.979f;
    PhaseDisplay phaseDisplay = PhaseDisplay::logarithmic;
    float phaseTruncationDeg = 10.0f;
    PhaseSpec uniformPhase;
    float equalExtinctionM2PerKg = 10.0f;

    float sunAzimuthDeg = 225.0f;
    float sunElevationDeg = 35.0f;
    float sunIntensity = 1.0f;
    glm::vec3 sunColour{1.0f, 0.96f, 0.90f};

    glm::vec3 skyZenith{0.03f, 0.09f, 0.26f};
    glm::vec3 skyHorizon{0.20f, 0.30f, 0.44f};
    float skyIntensity = 1.0f;
    float skylight = 0.25f;
    bool groundVisible = true;
    glm::vec3 groundColour{0.13f, 0.12f, 0.065f};

    Engine engine{};
    float quality = 1.0f;  ///< steps a voxel of the march
    int planes = 256;
    float targetError = 0.02f;  ///< relative standard error at which the reference rests
    int seed = 0;
    float exposureEv = 0.4f;
    ToneMap toneMap = ToneMap::filmic;

    std::array<SpeciesLook, kSpeciesCount> species;

    SpeciesLook& of(Species s) { return species[static_cast<std::size_t>(s)]; }
    const SpeciesLook& of(Species s) const { return species[static_cast<std::size_t>(s)]; }
    bool operator==(const Look&) const = default;
};

enum class ParameterKind : int { toggle, integer, number, choice, colour };
using ParameterValue = std::variant<bool, int, float, glm::vec3>;  // a choice is an int

struct ParameterRange {
    double lo = 0.0;
    double hi = 1.0;
    bool log = false;  ///< sliders are logarithmic; zero, if allowed, sits at the left stop
};

struct Parameter {
    std::string id;
    std::string label;
    std::string group;  ///< heading in the panel and the reference page
    std::string unit;   ///< of the value; "1" for a pure number, empty for toggles and choices
    std::string help;   ///< one line: meaning, equation, source
    ParameterKind kind = ParameterKind::number;
    ParameterRange range;
    std::span<const std::string_view> choices;       ///< spelling in JSON and --set
    std::span<const std::string_view> choiceLabels;  ///< spelling on screen
    Stage invalidates = Stage::medium;
    std::string displayUnit;    ///< unit on screen, "µm"; empty where `unit` is "1" or empty
    double displayScale = 1.0;  ///< screen value = value × displayScale
    std::optional<Species> species;
    std::size_t offset = 0;  ///< of the value within Look
    /// Of a parameter of a phase function: which one, and where in Look its PhaseSpec lies.
    float PhaseSpec::*phaseMember = nullptr;
    std::size_t phaseOffset = 0;
    bool ofConstantRadius = false;   ///< acts only where the radius of `species` is a constant
    unsigned engines = kAllEngines;  ///< with which it acts, bits
};

/// All parameters in the order of the panels.
std::span<const Parameter> lookTable();

/// nullptr when there is none of that id.
const Parameter* findParameter(std::string_view id);

/// The row of that id; throws Error naming the nearest known id.
const Parameter& parameter(std::string_view id);

ParameterValue valueOf(const Look& look, const Parameter& row);
ParameterValue defaultOf(const Parameter& row);

/// Stores a value; throws Error naming id, value and range or choices when it does not fit. `where`
/// opens the message.
void setValue(Look& look, const Parameter& row, const ParameterValue& value,
              std::string_view where = {});

/// What a parameter takes, in words: "a number from 0 to 90 deg", "one of physical, equal".
std::string rangeText(const Parameter& row);

/// Text of a value as `--set` reads it: 0.5, true, translucent, or r,g,b.
std::string formatValue(const Parameter& row, const ParameterValue& value);
/// Reads such text; throws Error.
ParameterValue parseValue(const Parameter& row, std::string_view text, std::string_view where = {});

/// Applies one `id=value`; throws Error.
void applyAssignment(Look& look, std::string_view assignment);

/// What follows a number on screen: " µm", "°", or nothing.
std::string unitSuffix(const Parameter& row);
/// Text of a value as the screen shows it: 10 µm, on, Translucent.
std::string screenText(const Parameter& row, const ParameterValue& value);

/// Whether a row acts at present: a parameter of a phase function acts where its kind reads it, a
/// constant radius where none comes from the model, a row of one engine while that engine draws.
bool applies(const Parameter& row, const Look& look);

/// The earliest stage that differs between two looks; none when they are equal.
std::optional<Stage> firstDifference(const Look& a, const Look& b);

/// The known id that is nearest in spelling, for messages; empty when nothing is near.
std::string nearestParameterId(std::string_view id);

/// Unit vector towards the sun in world space.
glm::dvec3 sunDirWorld(const Look& look);

}  // namespace neph
