// look_table.cpp: the rows of the look table. A long table is data: one row, one parameter.
#include <fmt/format.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "core/look/look.h"
#include "core/optics/phase_functions.h"

namespace neph {
namespace {

constexpr auto kEngineIds = eachEngine(&EngineTraits::id);
constexpr auto kEngineLabels = eachEngine(&EngineTraits::label);
constexpr unsigned kSingleScattering = enginesWith(&EngineTraits::singleScattering, true);
constexpr std::array<std::string_view, 2> kTransportIds{"low_albedo", "translucent"};
constexpr std::array<std::string_view, 2> kTransportLabels{"Low albedo", "Translucent"};
constexpr std::array<std::string_view, 2> kPhaseModeIds{"uniform", "per_field"};
constexpr std::array<std::string_view, 2> kPhaseModeLabels{"Uniform", "Per field"};
constexpr std::array<std::string_view, 2> kExtinctionIds{"physical", "equal"};
constexpr std::array<std::string_view, 2> kExtinctionLabels{"Physical", "Equal"};
constexpr std::array<std::string_view, 2> kOpticsIds{"geometric", "wrf_rrtmg"};
constexpr std::array<std::string_view, 2> kOpticsLabels{"Geometric", "As WRF RRTMG"};
constexpr std::array<std::string_view, 4> kSourceIds{"constant", "file", "number", "scheme"};
constexpr std::array<std::string_view, 4> kSourceLabels{"Constant", "From the file", "From number",
                                                        "By the scheme"};
constexpr std::array<std::string_view, 2> kColourIds{"natural", "fields"};
constexpr std::array<std::string_view, 2> kColourLabels{"Natural", "By field"};
constexpr std::array<std::string_view, 2> kLightFormIds{"printed", "consistent"};
constexpr std::array<std::string_view, 2> kLightFormLabels{"As printed", "Step-consistent"};
constexpr std::array<std::string_view, 3> kDisplayIds{"linear", "logarithmic", "physical"};
constexpr std::array<std::string_view, 3> kDisplayLabels{"Linear", "Logarithmic", "Physical"};
constexpr std::array<std::string_view, 2> kToneMapIds{"linear", "filmic"};
constexpr std::array<std::string_view, 2> kToneMapLabels{"Linear", "Filmic"};
constexpr std::array<std::string_view, 2> kNoiseIds{"billow", "wisp"};
constexpr std::array<std::string_view, 2> kNoiseLabels{"Billow", "Wisp"};

using Names = std::span<const std::string_view>;

/// A unit as it is written on screen; nothing for a pure number.
std::string_view onScreen(std::string_view unit) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kSpellings{
        {{"1", ""}, {"deg", "°"}, {"kg m-3", "kg/m³"}, {"m2 kg-1", "m²/kg"}}};
    for (const auto& [plain, pretty] : kSpellings) {
        if (plain == unit) return pretty;
    }
    return unit;
}

std::size_t offsetIn(float PhaseSpec::*member) {
    static const PhaseSpec spec;
    return static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&(spec.*member)) -
                                    reinterpret_cast<const std::byte*>(&spec));
}

/// Builds rows; `at` is the offset of the group's struct within Look and `prefix` opens the ids.
class Rows {
  public:
    std::vector<Parameter> take() { return std::move(rows_); }

    void begin(std::string group, std::string prefix, std::size_t at,
               std::optional<Species> species = {}) {
        group_ = std::move(group);
        prefix_ = std::move(prefix);
        at_ = at;
        species_ = species;
    }
    Parameter& toggle(std::string_view id, std::string_view label, std::size_t offset, Stage stage,
                      std::string_view help) {
        return add(id, label, ParameterKind::toggle, offset, stage, help);
    }
    Parameter& choice(std::string_view id, std::string_view label, std::size_t offset, Stage stage,
                      Names ids, Names labels, std::string_view help) {
        Parameter& row = add(id, label, ParameterKind::choice, offset, stage, help);
        row.choices = ids;
        row.choiceLabels = labels;
        return row;
    }
    Parameter& number(std::string_view id, std::string_view label, std::string_view unit,
                      std::size_t offset, ParameterRange range, Stage stage,
                      std::string_view help) {
        Parameter& row = add(id, label, ParameterKind::number, offset, stage, help);
        row.unit = unit;
        row.displayUnit = onScreen(unit);
        row.range = range;
        return row;
    }
    Parameter& integer(std::string_view id, std::string_view label, std::string_view unit,
                       std::size_t offset, ParameterRange range, Stage stage,
                       std::string_view help) {
        Parameter& row = number(id, label, unit, offset, range, stage, help);
        row.kind = ParameterKind::integer;
        return row;
    }
    Parameter& colour(std::string_view id, std::string_view label, std::size_t offset, Stage stage,
                      std::string_view help) {
        Parameter& row = add(id, label, ParameterKind::colour, offset, stage, help);
        row.unit = "1";
        row.range = {0.0, 1.0};
        return row;
    }
    /// A phase function's kind and parameters; `spec` is the offset of its PhaseSpec.
    void phase(std::string_view id, std::size_t spec);

  private:
    Parameter& phaseNumber(const std::string& id, std::string_view label, std::string_view unit,
                           std::size_t spec, float PhaseSpec::*member, ParameterRange range,
                           std::string_view help) {
        Parameter& row =
            number(id, label, unit, spec + offsetIn(member), range, Stage::medium, help);
        row.phaseMember = member;
        row.phaseOffset = at_ + spec;
        return row;
    }
    Parameter& add(std::string_view id, std::string_view label, ParameterKind kind,
                   std::size_t offset, Stage stage, std::string_view help) {
        Parameter& row = rows_.emplace_back();
        row.id = prefix_ + std::string(id);
        row.label = label;
        row.group = group_;
        row.help = help;
        row.kind = kind;
        row.invalidates = stage;
        row.species = species_;
        row.offset = at_ + offset;
        return row;
    }

    std::vector<Parameter> rows_;
    std::string group_, prefix_;
    std::size_t at_ = 0;
    std::optional<Species> species_;
};

std::vector<std::string_view> columnOf(std::string_view PhaseFunction::*text) {
    std::vector<std::string_view> column;
    for (const PhaseFunction& function : phaseFunctions()) column.push_back(function.*text);
    return column;
}

void Rows::phase(std::string_view id, std::size_t spec) {
    static const auto kIds = columnOf(&PhaseFunction::id);
    static const auto kLabels = columnOf(&PhaseFunction::label);
    const std::string p(id);
    choice(p, "Phase function", spec + offsetof(PhaseSpec, kind), Stage::medium, kIds, kLabels,
           "Angular distribution of scattered light, P in Eq. 5. docs/physics.md §2");
    phaseNumber(p + "_g", "Asymmetry g", "1", spec, &PhaseSpec::g, {-0.99, 0.999},
                "g of Henyey-Greenstein, Draine and Cornette-Shanks; first lobe of the double HG.");
    phaseNumber(p + "_g2", "Second lobe g", "1", spec, &PhaseSpec::g2, {-0.99, 0.99},
                "g of the second lobe of the double Henyey-Greenstein.");
    phaseNumber(p + "_weight", "First lobe share", "1", spec, &PhaseSpec::weight, {0.0, 1.0},
                "Share of the first lobe of the double Henyey-Greenstein.");
    phaseNumber(p + "_alpha", "Draine alpha", "1", spec, &PhaseSpec::alpha, {0.0, 250.0},
                "0 is Henyey-Greenstein, 1 Cornette-Shanks. [Draine03]");
    Parameter& radius = phaseNumber(
        p + "_radius", "Phase radius", "m", spec, &PhaseSpec::radiusM, {1e-6, 110e-6, true},
        "Effective radius of the droplets or crystals whose phase function is used; the extinction "
        "has its own. Droplets count up to 50 µm.");
    radius.displayUnit = "µm";
    radius.displayScale = 1e6;
}

void addModes(Rows& rows) {
    rows.begin("Modes", "mode.", 0);
    rows.choice("transport", "Light", offsetof(Look, transport), Stage::light, kTransportIds,
                kTransportLabels,
                "How sunlight reaches a sample: Beer-Lambert alone, or with forward scattering "
                "(Eq. 12, 14-17).")
        .engines = kSingleScattering;
    rows.choice("phase", "Phase", offsetof(Look, phaseMode), Stage::medium, kPhaseModeIds,
                kPhaseModeLabels,
                "One phase function for all fields, or each field its own weighted by scattering "
                "coefficient (Eq. 18).");
    rows.toggle("noise", "Detail noise", offsetof(Look, noise), Stage::medium,
                "Perlin detail below the grid, each field its own amount. [Riley03] §4.5");
    rows.choice("extinction", "Extinction", offsetof(Look, extinction), Stage::medium,
                kExtinctionIds, kExtinctionLabels,
                "From each field's radius and density (Eq. 9), or the same per kilogram for all.");
    rows.choice("radiation_optics", "Model radii", offsetof(Look, radiationOptics), Stage::data,
                kOpticsIds, kOpticsLabels,
                "How much light particles of the model's radius take away: large spheres, or as "
                "WRF's RRTMG has ice and snow. Acts on fields whose radius is not a constant. "
                "docs/physics.md §7");
    rows.choice("colour", "Colour", offsetof(Look, colour), Stage::medium, kColourIds,
                kColourLabels, "White hydrometeors, or the field colours of [Riley03] table 2.");
}

void addLight(Rows& rows) {
    rows.begin("Light", "light.", 0);
    rows.choice("form", "Forward scattering", offsetof(Look, lightForm), Stage::light,
                kLightFormIds, kLightFormLabels,
                "Eq. 14-17 as printed, which depend on the number of planes, or the form that does "
                "not, which the march always uses. docs/physics.md §1")
        .engines = enginesWith(&EngineTraits::printedLight, true);
    rows.number("forward_angle", "Forward angle", "deg", offsetof(Look, forwardAngleDeg),
                {0.0, 60.0}, Stage::light,
                "Full opening of the arc that counts as forward scattered, theta_f of Eq. 15-16.")
        .engines = kSingleScattering;
    rows.number("forward_g", "Forward g", "1", offsetof(Look, forwardG), {0.0, 0.999}, Stage::light,
                "Cornette-Shanks g whose cumulative gives the forward share; 0.979 puts 90 % "
                "within 10 degrees, as [Riley03] fig. 7.")
        .engines = kSingleScattering;
    rows.number("equal_extinction", "Equal extinction", "m2 kg-1",
                offsetof(Look, equalExtinctionM2PerKg), {0.01, 1000.0, true}, Stage::medium,
                "Mass extinction of every field when mode.extinction is equal.");
    rows.choice("phase_display", "Phase display", offsetof(Look, phaseDisplay), Stage::eye,
                kDisplayIds, kDisplayLabels,
                "Phase normalised by its range with the peak cut, on a linear or logarithmic scale "
                "as [Riley03] fig. 10; or the true value x 4 pi.")
        .engines = kSingleScattering;
    rows.number("phase_truncation", "Peak cut at", "deg", offsetof(Look, phaseTruncationDeg),
                {0.1, 60.0, true}, Stage::eye,
                "The phase function is cut at its value at this angle when it is normalised.")
        .engines = kSingleScattering;
    rows.phase("uniform_phase", offsetof(Look, uniformPhase));
}

void addSunAndSky(Rows& rows) {
    rows.begin("Sun and sky", "", 0);
    rows.number("sun.azimuth", "Sun azimuth", "deg", offsetof(Look, sunAzimuthDeg), {0.0, 360.0},
                Stage::light, "Where the sun stands, clockwise from north.");
    rows.number("sun.elevation", "Sun elevation", "deg", offsetof(Look, sunElevationDeg),
                {-10.0, 90.0}, Stage::light, "Height of the sun above the horizon.");
    rows.number("sun.intensity", "Sun intensity", "1", offsetof(Look, sunIntensity),
                {0.0, 20.0, true}, Stage::eye,
                "Irradiance L_lt of Eq. 12; 1 makes isotropic scatter of full light radiance 1.");
    rows.colour("sun.colour", "Sun colour", offsetof(Look, sunColour), Stage::eye,
                "Linear RGB of sunlight.");
    rows.colour("sky.zenith", "Sky zenith", offsetof(Look, skyZenith), Stage::eye,
                "Radiance of the sky overhead, linear RGB.");
    rows.colour("sky.horizon", "Sky horizon", offsetof(Look, skyHorizon), Stage::eye,
                "Radiance of the sky at the horizon, linear RGB.");
    rows.number("sky.intensity", "Sky intensity", "1", offsetof(Look, skyIntensity), {0.0, 5.0},
                Stage::eye, "Multiplies the sky's radiance: L_bg of Eq. 5 and the skylight.");
    rows.number("sky.skylight", "Skylight", "1", offsetof(Look, skylight), {0.0, 2.0}, Stage::eye,
                "Share of the sky's radiance that lights the cloud, dimmed by what lies above and "
                "below. Not in [Riley03]. docs/physics.md §5")
        .engines = kSingleScattering;
    rows.toggle("ground.visible", "Ground", offsetof(Look, groundVisible), Stage::eye,
                "A plane at height 0; off shows the sky below the horizon too.");
    rows.colour("ground.colour", "Ground colour", offsetof(Look, groundColour), Stage::eye,
                "Linear RGB radiance of the ground in full light.");
}

/// "March: light is computed once ... Half-angle slicing: ..."
std::string enginesHelp() {
    std::string help;
    for (const EngineTraits& engine : kEngines) {
        help += fmt::format("{}{}: {}", help.empty() ? "" : " ", engine.label, engine.help);
    }
    return help;
}

void addView(Rows& rows) {
    rows.begin("View", "view.", 0);
    rows.choice("engine", "Engine", offsetof(Look, engine), Stage::medium, kEngineIds,
                kEngineLabels, enginesHelp());
    rows.number("quality", "Quality", "1", offsetof(Look, quality), {0.25, 8.0, true}, Stage::eye,
                "Steps of the march for each voxel that a ray crosses; fewer where little is, more "
                "where much is. The error falls with its square. docs/performance.md")
        .engines = enginesWith(&EngineTraits::fineness, Fineness::stepsPerVoxel);
    rows.integer("planes", "Planes", "1", offsetof(Look, planes), {16, 2048, true}, Stage::light,
                 "Number of slices through the occupied part of the volume.")
        .engines = enginesWith(&EngineTraits::fineness, Fineness::planes);
    Parameter& error =
        rows.number("target_error", "Target error", "1", offsetof(Look, targetError),
                    {0.0005, 0.5, true}, Stage::resolve,
                    "The reference adds paths until its relative standard error over the picture "
                    "is this small. docs/accuracy.md");
    error.engines = enginesWith(&EngineTraits::refinement, Refinement::converges);
    error.displayUnit = "%";
    error.displayScale = 100.0;
    rows.integer("seed", "Seed", "1", offsetof(Look, seed), {0, 1000000}, Stage::eye,
                 "Of the reference's random numbers: the same seed gives the same picture.")
        .engines = enginesWith(&EngineTraits::refinement, Refinement::converges);
    rows.number("exposure", "Exposure", "EV", offsetof(Look, exposureEv), {-10.0, 10.0},
                Stage::resolve, "Scene-referred gain, 2^EV, before the film curve.");
    rows.choice("tone_map", "Film curve", offsetof(Look, toneMap), Stage::resolve, kToneMapIds,
                kToneMapLabels, "Filmic shoulder and toe, or linear with clipping.");
}

/// Where the radius of a species comes from, and the constant one.
void addRadius(Rows& rows) {
    rows.choice("radius_source", "Radius from", offsetof(SpeciesLook, radiusSource), Stage::data,
                kSourceIds, kSourceLabels,
                "A constant, or cell by cell from the model: effective radii in the file, numbers "
                "of particles, or the microphysics scheme's own size distribution; what is missing "
                "is replaced by the next of these. The largest change a picture can have: a "
                "model's ice of 20-50 µm has 82-33 m²/kg, the paper's of 1 mm 1.64, so anvils "
                "become 20 to 50 times more opaque. Reads the data again. docs/physics.md §7");
    Parameter& radius =
        rows.number("effective_radius", "Effective radius", "m",
                    offsetof(SpeciesLook, effectiveRadiusM), {1e-6, 1e-2, true}, Stage::medium,
                    "Constant radius in Eq. 3 and 9; extinction goes as 1/r. [Riley03] table 3");
    radius.displayUnit = "µm";
    radius.displayScale = 1e6;
    radius.ofConstantRadius = true;
    rows.number("density", "Particle density", "kg m-3", offsetof(SpeciesLook, densityKgPerM3),
                {10.0, 1000.0, true}, Stage::medium,
                "Density of one particle of the constant radius, Eq. 3; extinction goes as "
                "1/density.")
        .ofConstantRadius = true;
}

void addSpecies(Rows& rows, Species s) {
    const std::size_t at =
        offsetof(Look, species) + static_cast<std::size_t>(s) * sizeof(SpeciesLook);
    const std::string prefix = std::string(info(s).id) + ".";
    rows.begin(std::string(info(s).label), prefix, at, s);
    rows.toggle("visible", "Visible", offsetof(SpeciesLook, visible), Stage::medium,
                "Whether the field takes part at all.");
    rows.number("mixing_scale", "Mixing scale", "1", offsetof(SpeciesLook, mixingScale),
                {0.0, 100.0, true}, Stage::medium,
                "Multiplies the field's mixing ratio, H in Eq. 1. [Riley03] §5");
    addRadius(rows);
    rows.number("albedo", "Albedo", "1", offsetof(SpeciesLook, albedo), {0.0, 1.0}, Stage::medium,
                "Single-scattering albedo: share of extinction that scatters, Eq. 10.");
    rows.colour("colour", "Field colour", offsetof(SpeciesLook, colour), Stage::medium,
                "Colour when mode.colour is fields. [Riley03] table 2");
    rows.phase("phase", offsetof(SpeciesLook, phase));
    rows.number("noise_amount", "Noise amount", "1", offsetof(SpeciesLook, noiseAmount), {0.0, 4.0},
                Stage::medium,
                "Portion of the field that the noise multiplies, [Riley03] §4.5; above 1 the thin "
                "parts are eaten away.");
    Parameter& scale = rows.number("noise_scale", "Noise scale", "m",
                                   offsetof(SpeciesLook, noiseScaleM), {50.0, 1e5, true},
                                   Stage::medium, "Length of the largest features of the noise.");
    scale.displayUnit = "km";
    scale.displayScale = 1e-3;
    rows.choice("noise_character", "Noise character", offsetof(SpeciesLook, noiseCharacter),
                Stage::medium, kNoiseIds, kNoiseLabels,
                "Billowing as convective cloud, or wispy as cirrus.");
}

std::vector<Parameter> build() {
    Rows rows;
    addModes(rows);
    for (int s = 0; s < kSpeciesCount; ++s) addSpecies(rows, static_cast<Species>(s));
    addLight(rows);
    addSunAndSky(rows);
    addView(rows);
    return rows.take();
}

}  // namespace

std::span<const Parameter> lookTable() {
    static const std::vector<Parameter> table = build();
    return table;
}

Look::Look() {
    // Sizes of phase functions and amounts of noise are tuned by eye: droplets of cloud and of
    // drizzle, crystals of cirrus (extinction has its own radii, those of the paper).
    for (int i = 0; i < kSpeciesCount; ++i) {
        const auto s = static_cast<Species>(i);
        SpeciesLook& field = of(s);
        field.effectiveRadiusM = info(s).radiusM;
        field.densityKgPerM3 = info(s).densityKgPerM3;
        field.colour = {info(s).colour[0], info(s).colour[1], info(s).colour[2]};
        const bool liquid = info(s).liquid;
        field.phase.kind = liquid ? PhaseKind::waterDroplets : PhaseKind::roughAggregate;
        field.phase.radiusM = liquid ? 10e-6f : 30e-6f;
        field.noiseCharacter = liquid ? NoiseCharacter::billow : NoiseCharacter::wisp;
        field.noiseAmount = 0.6f;
    }
    of(Species::rain).phase.radiusM = 25e-6f;
}

}  // namespace neph
