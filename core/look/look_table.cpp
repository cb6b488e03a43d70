// look_table.cpp: the rows of what all fields share, and the table put together. A long table is
// data: one row, one parameter.
#include "core/look/look_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/look/haze.h"
#include "core/look/parameter_rows.h"

namespace neph {
namespace {

constexpr unsigned kSingleScattering = enginesWith(&EngineTraits::singleScattering, true);

/// Makes up for scatterings that are not followed, and acts where they are not.
Parameter& ofOneScattering(Parameter& row) {
    row.engines = kSingleScattering;
    row.acts = [](const Look& look) { return !scattersOften(look); };
    return row;
}

bool hasGlare(const Look& look) {
    return look.skyModel == SkyModel::atmosphere && look.sunDisc &&
           look.toneMap != ToneMap::reflectance;
}

std::vector<Choice> engineChoices() {
    std::vector<Choice> choices;
    for (const EngineTraits& engine : kEngines) {
        choices.push_back({engine.id, engine.label, engine.help});
    }
    return choices;
}

/// "March: light is computed once ... Half-angle slicing: ..."
std::string enginesHelp() {
    std::string help;
    for (const EngineTraits& engine : kEngines) {
        help += fmt::format("{}{}: {}", help.empty() ? "" : " ", engine.label, engine.help);
    }
    return help;
}

std::vector<Parameter> build() {
    std::vector<Parameter> table;
    addModes(table);
    addFields(table);
    addLight(table);
    addUniformPhase(table);
    addSunAndSky(table);
    addView(table);
    addSampling(table);
    return table;
}

}  // namespace

std::string_view unitOnScreen(std::string_view unit) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kSpellings{
        {{"1", ""}, {"deg", "°"}, {"kg m-3", "kg/m³"}, {"m2 kg-1", "m²/kg"}}};
    for (const auto& [plain, pretty] : kSpellings) {
        if (plain == unit) return pretty;
    }
    return unit;
}

std::span<const Parameter> parameterTable() {
    static const std::vector<Parameter> table = build();
    return table;
}

std::span<const Parameter> lookTable() {
    return parameterTable().first(parameterTable().size() - samplingTable().size());
}

std::span<const Parameter> samplingTable() {
    static const auto count = static_cast<std::size_t>(
        std::ranges::count(parameterTable(), ParameterPart::sampling, &Parameter::part));
    return parameterTable().last(count);
}

void addModes(std::vector<Parameter>& table) {
    LookRows rows(table, {.name = "Modes", .prefix = "mode.", .part = ParameterPart::fields});
    rows.choice("phase", "Phase", &Look::phaseMode, Stage::medium,
                {{"uniform", "Uniform", "The uniform phase function for all fields."},
                 {"per_field", "Per field",
                  "Each field its own, weighted by scattering coefficient, Eq. 18."}},
                "One phase function for all fields, or each field its own weighted by scattering "
                "coefficient (Eq. 18).");
    rows.toggle("noise", "Detail noise", &Look::noise, Stage::medium,
                "Perlin detail below the grid, each field its own amount. [Riley03] §4.5");
    rows.choice(
        "extinction", "Extinction", &Look::extinction, Stage::medium,
        {{"physical", "Physical", "3 / (2 r rho) per kilogram: Eq. 9 with each field's size."},
         {"equal", "Equal",
          "The same m²/kg for every field: amounts of mass can be compared by eye."}},
        "From each field's radius and density (Eq. 9), or the same per kilogram for all.");
    rows.choice("radiation_optics", "Model radii", &Look::radiationOptics, Stage::data,
                {{"geometric", "Geometric", "Large spheres: extinction efficiency 2."},
                 {"wrf_rrtmg", "As WRF RRTMG",
                  "As WRF's radiation code has ice and snow of the model's radius."}},
                "How much light particles of the model's radius take away: large spheres, or as "
                "WRF's RRTMG has ice and snow. Acts on fields whose radius is not a constant. "
                "docs/physics.md §7");
    rows.choice(
        "mixing", "Mixing scales", &Look::mixing, Stage::medium,
        {{"as_given", "As given", "The same share of the mixing ratio, whatever the data."},
         {"by_cell", "By cell size",
          "For cells of 1 km; finer cells keep more, up to all that the model has."}},
        "Whether mixing scales below 1 hold for any data, or for cells of 1 km: in cells of 100 m "
        "they are then ten times as large, at most 1, so that a small cloud is as opaque cell for "
        "cell as a storm. docs/physics.md §8");
    rows.choice("colour", "Colour", &Look::colour, Stage::medium,
                {{"natural", "Natural", "White particles, coloured by the light alone."},
                 {"fields", "By field", "Each field in its field colour, [Riley03] table 2."}},
                "White hydrometeors, or the field colours of [Riley03] table 2.");
}

void addLight(std::vector<Parameter>& table) {
    LookRows rows(table, {.name = "Light", .prefix = "light.", .part = ParameterPart::light});
    Parameter& transport = rows.choice(
        "transport", "Transport", &Look::transport, Stage::light,
        {{"low_albedo", "Low albedo",
          "Beer-Lambert alone: what is scattered is lost. Dark, for thin or absorbing media."},
         {"translucent", "Translucent",
          "Light scattered nearly forward goes on to light what lies behind, Eq. 12, 14-17."},
         {"full", "Full",
          "Light scattered any number of times, in every direction, by the march; physical "
          "radiance. Half-angle slicing shows Translucent instead. docs/transport.md"}},
        "How light reaches a sample: Beer-Lambert alone, with forward scattering (Eq. 12, 14-17), "
        "or after any number of scatterings.");
    transport.engines = kSingleScattering;
    transport.formerId = "mode.transport";
    Parameter& sides = rows.choice(
        "sides", "Domain sides", &Look::domainSides, Stage::medium,
        {{"open", "Open", "Nothing is beside what is shown; light comes in from there."},
         {"periodic", "Periodic",
          "What is shown is there again and again in x and y, to the horizon: drawn and lit as the "
          "endless field that it is a part of."}},
        "What lies beside what is shown, for light and eye: nothing, or the same again and again "
        "to the horizon, as in large-eddy simulations. That it repeats is assumed, also of a "
        "region or of a domain with other sides. The sun is at least 1 degree off the horizon. "
        "Half-angle slicing has open sides. docs/transport.md");
    sides.engines = enginesWith(&EngineTraits::periodicSides, true);
    sides.id = "domain.sides";
    sides.formerId = "light.sides";
    rows.choice(
            "form", "Forward scattering", &Look::lightForm, Stage::light,
            {{"printed", "As printed", "As the paper prints it: brightness depends on the planes."},
             {"consistent", "Step-consistent",
              "The same light however many planes. docs/physics.md §1"}},
            "Eq. 14-17 as printed, which depend on the number of planes, or the form that does "
            "not, which the march always uses. docs/physics.md §1")
        .engines = enginesWith(&EngineTraits::printedLight, true);
    ofOneScattering(rows.number(
        "forward_angle", "Forward angle", "deg", &Look::forwardAngleDeg, {0.0, 60.0}, Stage::light,
        "Full opening of the arc that counts as forward scattered, theta_f of "
        "Eq. 15-16."));
    ofOneScattering(
        rows.number("forward_g", "Forward g", "1", &Look::forwardG, {0.0, 0.999}, Stage::light,
                    "Cornette-Shanks g whose cumulative gives the forward share; 0.979 puts 90 % "
                    "within 10 degrees, as [Riley03] fig. 7."));
    rows.number("equal_extinction", "Equal extinction", "m2 kg-1", &Look::equalExtinctionM2PerKg,
                {0.01, 1000.0, true}, Stage::medium,
                "Mass extinction of every field when mode.extinction is equal.")
        .part = ParameterPart::fields;
    ofOneScattering(rows.choice(
        "phase_display", "Phase display", &Look::phaseDisplay, Stage::eye,
        {{"linear", "Linear", "Cut at the peak and normalised, linear: no radiance."},
         {"logarithmic", "Logarithmic",
          "Cut at the peak and normalised, logarithmic, as [Riley03] fig. 10: no radiance."},
         {"physical", "Physical", "The true value times 4 pi: radiance."}},
        "The true value x 4 pi, which makes the image a radiance; or, for figures, normalised by "
        "its range with the peak cut, on a linear or logarithmic scale as [Riley03] fig. 10."));
    Parameter& truncation = ofOneScattering(
        rows.number("phase_truncation", "Phase truncation angle", "deg", &Look::phaseTruncationDeg,
                    {0.1, 60.0, true}, Stage::eye,
                    "The phase function is cut at its value at this angle when it is normalised."));
    truncation.acts = [](const Look& look) {
        return !scattersOften(look) && look.phaseDisplay != PhaseDisplay::physical;
    };
}

/// Where the sun stands.
void addSun(LookRows& rows) {
    const auto bySource = [](Parameter& row, SunSource source) {
        row.acts = [source](const Look& look) { return look.sunSource == source; };
    };
    rows.choice("sun.source", "Sun by", &Look::sunSource, Stage::light,
                {{"angles", "Angles", "Azimuth and elevation."},
                 {"date", "Date and place",
                  "Date, time and place of the data; what they do not state from this look."}},
                "Where the sun stands: by angles, or where it is at the date and place of the "
                "data. docs/physics.md §9");
    rows.choice("sun.body", "Light of", &Look::sunBody, Stage::light,
                {{"sun", "The sun", "By day and in twilight."},
                 {"moon", "The moon",
                  "In the place of the sun: 400,000 times fainter when full, by its phase."}},
                "What lights the scene under an atmosphere. What is said of the sun holds for the "
                "moon in its place; by a date it stands where the moon does.")
        .acts = [](const Look& look) { return look.skyModel == SkyModel::atmosphere; };
    const auto ofMoon = [](Parameter& row) {
        row.acts = [](const Look& look) {
            return look.skyModel == SkyModel::atmosphere && look.sunBody == LightBody::moon &&
                   look.sunSource == SunSource::angles;
        };
    };
    ofMoon(rows.number("sun.moon_phase", "Phase angle", "deg", &Look::moonPhaseDeg, {0.0, 170.0},
                       Stage::light, "Of the moon: 0 is full, 90 a quarter."));
    ofMoon(rows.number("sun.moon_limb", "Bright limb", "deg", &Look::moonLimbDeg, {0.0, 360.0},
                       Stage::eye, "Side that is lit, clockwise from the vertical: 90 is right."));
    bySource(rows.number("sun.azimuth", "Sun azimuth", "deg", &Look::sunAzimuthDeg, {0.0, 360.0},
                         Stage::light, "Where the sun stands, clockwise from north."),
             SunSource::angles);
    bySource(rows.number("sun.elevation", "Sun elevation", "deg", &Look::sunElevationDeg,
                         {-12.0, 90.0}, Stage::light, "Height of the sun above the horizon."),
             SunSource::angles);
    bySource(rows.number("sun.latitude", "Latitude", "deg", &Look::sunLatitudeDeg, {-90.0, 90.0},
                         Stage::light, "North, of data that state no place; else theirs acts."),
             SunSource::date);
    bySource(
        rows.number("sun.longitude", "Longitude", "deg", &Look::sunLongitudeDeg, {-180.0, 180.0},
                    Stage::light, "East, of data that state no place; else theirs acts."),
        SunSource::date);
    bySource(rows.integer("sun.day", "Day of the year", "1", &Look::sunDay, {1, 366}, Stage::light,
                          "Of 2024, where data state no date: 80 is 20 March, 172 is 20 June, "
                          "266 is 22 September, 356 is 21 December."),
             SunSource::date);
    bySource(rows.number("sun.hour", "Hour in UTC", "1", &Look::sunHour, {0.0, 24.0}, Stage::light,
                         "Of the shown time, where data state no date."),
             SunSource::date);
}

void addSunAndSky(std::vector<Parameter>& table) {
    LookRows rows(table, {.name = "Sun and sky", .prefix = "", .part = ParameterPart::light});
    addSun(rows);
    rows.number("sun.intensity", "Sun intensity", "1", &Look::sunIntensity, {0.0, 20.0, true},
                Stage::eye,
                "Irradiance L_lt of Eq. 12; 1 makes isotropic scatter of full light radiance 1. "
                "With the atmosphere, of the sun outside it.");
    rows.choice("sky.model", "Sky", &Look::skyModel, Stage::light,
                {{"gradient", "Gradient", "Two colours, as L_bg of [Riley03]; no haze on clouds."},
                 {"atmosphere", "Atmosphere",
                  "Air, haze and ozone around a round Earth: they colour the sun, make the sky and "
                  "veil what is far. docs/sky.md"}},
                "Where the light of the sky comes from: two colours, or air of a given visibility, "
                "which also dims and colours the sun and veils what is far.");
    const auto ofGradient = [](Parameter& row) {
        row.acts = [](const Look& look) { return look.skyModel == SkyModel::gradient; };
    };
    const auto ofAtmosphere = [](Parameter& row) {
        row.acts = [](const Look& look) { return look.skyModel == SkyModel::atmosphere; };
    };
    ofAtmosphere(rows.choice(
        "sky.haze", "Haze", &Look::haze, Stage::data,
        {{"fixed", "Fixed", "Of the visibility below."},
         {"humidity", "By humidity",
          "Of the visibility that the mean humidity of the lowest layer of the data brings [UPP]; "
          "without water vapour in them, of the one below."},
         {"aerosol", "By aerosol",
          "Of the visibility that the aerosol of the lowest layer of the data brings at its "
          "humidity (WRF's QNWFA and QNIFA); without aerosol in them, by humidity."}},
        "Whether the haze is the same at all times or follows humidity or aerosol of the data. "
        "docs/sky.md"));
    Parameter& visibility = rows.number(
        "sky.visibility", "Visibility", "m", &Look::visibilityM,
        {kLeastVisibilityM, kMostVisibilityM, true}, Stage::light,
        "How far one sees through the haze near the ground, which thins by a factor e in 1.2 km; "
        "where haze does not follow the data.");
    visibility.displayUnit = "km";
    visibility.displayScale = 1e-3;
    ofAtmosphere(visibility);
    ofAtmosphere(rows.toggle("sun.disc", "Sun's disc", &Look::sunDisc, Stage::eye,
                             "Whether the disc itself is seen; off for measurements of an image, "
                             "whose errors it would outshine."));
    ofAtmosphere(rows.number("sky.ozone", "Ozone", "DU", &Look::ozoneDobson, {0.0, 600.0},
                             Stage::light, "Dobson units; ozone keeps the sky of twilight blue."));
    Parameter& air = rows.choice(
        "reference.air", "Air of the reference", &Look::referenceAir, Stage::eye,
        {{"traced", "Traced",
          "Molecules and haze within the grid scatter light: clouds throw shadows on them and "
          "light them."},
         {"tables", "Tables", "Clear air from tables, as the other engines have it."}},
        "Whether paths of light are scattered by the air within the grid. docs/sky.md");
    air.engines = enginesWith(&EngineTraits::groundTruth, true);
    ofAtmosphere(air);
    ofGradient(rows.colour("sun.colour", "Sun colour", &Look::sunColour, Stage::eye,
                           "Linear RGB of sunlight."));
    ofGradient(rows.colour("sky.zenith", "Sky zenith", &Look::skyZenith, Stage::eye,
                           "Radiance of the sky overhead, linear RGB."));
    ofGradient(rows.colour("sky.horizon", "Sky horizon", &Look::skyHorizon, Stage::eye,
                           "Radiance of the sky at the horizon, linear RGB."));
    ofGradient(rows.number("sky.intensity", "Sky intensity", "1", &Look::skyIntensity, {0.0, 5.0},
                           Stage::eye,
                           "Multiplies the sky's radiance: L_bg of Eq. 5 and the skylight."));
    ofOneScattering(
        rows.number("sky.skylight", "Skylight", "1", &Look::skylight, {0.0, 2.0}, Stage::eye,
                    "Share of the sky's radiance that lights the cloud, dimmed by what lies above "
                    "and below. Not in [Riley03]. docs/physics.md §5"));
    rows.toggle("ground.visible", "Ground", &Look::groundVisible, Stage::eye,
                "A plane at height 0; off shows the sky below the horizon too.");
    ofAtmosphere(rows.choice(
        "ground.surface", "Surface", &Look::groundSurface, Stage::light,
        {{"plain", "Plain", "One colour."},
         {"fields", "Fields", "Farmland in square miles, creeks and pasture, for a scale."},
         {"sea", "Sea", "Of its own colour, mirrors the sky; without the glint of the sun."}},
        "What the ground is under an atmosphere. It lights clouds by its mean."));
    rows.colour("ground.colour", "Ground colour", &Look::groundColour, Stage::eye,
                "Linear RGB radiance of the ground in full light; of fields the mean.")
        .acts = [](const Look& look) {
        return look.skyModel != SkyModel::atmosphere || look.groundSurface != GroundSurface::sea;
    };
}

void addView(std::vector<Parameter>& table) {
    LookRows rows(table, {.name = "View", .prefix = "view.", .part = ParameterPart::view});
    rows.choice("engine", "Engine", &Look::engine, Stage::medium, engineChoices(), enginesHelp())
        .alias = {
        "--engine", "NAME",
        fmt::format("Instead of view.engine: {}", fmt::join(eachEngine(&EngineTraits::id), ", "))};
    Parameter& planes = rows.integer(
        "planes", "Planes", "1", &Look::planes, {16, 2048, true}, Stage::light,
        "Number of slices through the occupied part of the volume. Part of the look, since with "
        "light as printed the brightness depends on it. docs/physics.md §3");
    planes.engines = enginesWith(&EngineTraits::fineness, Fineness::planes);
    planes.alias = {"--planes", "N", "Slices, slicing; instead of view.planes"};
    rows.number("exposure", "Exposure", "EV", &Look::exposureEv, {-10.0, 10.0}, Stage::resolve,
                "More or less than it is by the rows below, in stops: 2^EV.");
    rows.toggle("auto_exposure", "Exposure follows the light", &Look::autoExposure, Stage::resolve,
                "As a meter held at the cloud shows it: more exposure when the sun is low, "
                "whatever the camera looks at.")
        .acts = [](const Look& look) { return look.skyModel == SkyModel::atmosphere; };
    rows.number("ev100", "Exposure value", "EV", &Look::ev100, {-6.0, 20.0}, Stage::resolve,
                "At ISO 100, where exposure does not follow the light: 15 for sunlit land, 8 at "
                "sunset, 13.1 shows isotropic scatter of full sunlight as white.")
        .acts = [](const Look& look) {
        return look.skyModel != SkyModel::atmosphere || !look.autoExposure;
    };
    rows.choice("white_balance", "White balance", &Look::whiteBalance, Stage::resolve,
                {{"daylight", "Daylight", "As a camera set to daylight has it: a low sun is red."},
                 {"sun", "By sun", "What the sun and the sky throw on the clouds is white."}},
                "Which light is shown as white.");
    Parameter& glare = rows.number(
        "glare", "Lens glare", "1", &Look::glare, {0.0, 0.1}, Stage::resolve,
        "Share of the light of the sun's disc that strays in the lens and veils the image around "
        "it. What is measured and EXR files are without. docs/sky.md");
    glare.displayUnit = "%";
    glare.displayScale = 100.0;
    glare.acts = hasGlare;
    rows.choice(
        "tone_map", "Tone mapping", &Look::toneMap, Stage::resolve,
        {{"linear", "Linear", "Clipped where it is too bright."},
         {"filmic", "Filmic", "A toe and a shoulder, as on photographs. [Narkowicz15]"},
         {"agx", "AgX",
          "Sixteen stops; what is bright loses its colour, as on photographs. [Sobotka22]"},
         {"reflectance", "Reflectance factor",
          "As satellites report it: pi L over the irradiance of the sun outside the air, 0 to 1, "
          "whatever the exposure; the sun counts as at least 5 degrees high."}},
        "Filmic shoulder and toe, AgX, linear with clipping, or the reflectance factor.");
}

void addSampling(std::vector<Parameter>& table) {
    SamplingRows rows(table,
                      {.name = "Sampling", .prefix = "view.", .part = ParameterPart::sampling});
    Parameter& quality = rows.number(
        "quality", "Quality", "1", &Sampling::quality, {0.25, 8.0, true}, Stage::eye,
        "Steps of the march for each voxel that a ray crosses; fewer where little is, more "
        "where much is. The error falls with its square. docs/performance.md");
    quality.engines = enginesWith(&EngineTraits::fineness, Fineness::stepsPerVoxel);
    quality.alias = {"--quality", "NUMBER", "Steps per voxel, march; instead of view.quality"};
    rows.integer("light_voxels", "Voxels of light", "1", &Sampling::lightVoxels,
                 {1000, 20000000, true}, Stage::light,
                 "Most voxels in which full transport is solved, in the box of what is occupied. "
                 "docs/transport.md")
        .engines = enginesWith(&EngineTraits::scattersOften, true);
    Parameter& error =
        rows.number("target_error", "Target error", "1", &Sampling::targetError,
                    {0.0005, 0.5, true}, Stage::resolve,
                    "The reference adds paths until its relative standard error over the image "
                    "is this small. docs/accuracy.md");
    error.engines = enginesWith(&EngineTraits::refinement, Refinement::converges);
    error.displayUnit = "%";
    error.displayScale = 100.0;
    error.alias = {"--error", "PERCENT", "Reference; instead of view.target_error"};
    Parameter& seed =
        rows.integer("seed", "Seed", "1", &Sampling::seed, {0, 1000000}, Stage::eye,
                     "Of the reference's random numbers: the same seed gives the same image.");
    seed.engines = enginesWith(&EngineTraits::refinement, Refinement::converges);
    seed.alias = {"--seed", "N", "Reference; instead of view.seed"};
}

}  // namespace neph
