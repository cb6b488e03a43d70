// scene_file.cpp: parses scenes from untrusted JSON; every fault becomes an Error.
#include "app/validate/scene_file.h"

#include <array>

#include "app/validate/json_object.h"
#include "app/validate/scene_medium.h"
#include "core/optics/phase_functions.h"

namespace neph::validate {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 20;  // an inline grid of a few million cells
constexpr double kMaxLengthM = 1e6;
constexpr double kMaxExtinctionPerM = 1e3;
constexpr double kMaxOpticalDepth = 1e4;
constexpr double kMaxLight = 1e9;
constexpr int kMaxRepeat = 2048;
constexpr std::size_t kMaxViews = 1000;
constexpr std::size_t kMaxExperiments = 50;
constexpr std::size_t kMaxValues = std::size_t{1} << 26;  // all fields times all experiments

/// A parameter of phase functions, as a key of the file.
struct PhaseParameter {
    std::string_view key;
    float PhaseSpec::*member;
    Range range;
    double unit;  ///< factor from the file's unit to SI
};

constexpr std::array<PhaseParameter, 5> kPhaseParameters{
    {{"g", &PhaseSpec::g, {-0.999, 0.999}, 1.0},
     {"g2", &PhaseSpec::g2, {-0.999, 0.999}, 1.0},
     {"weight", &PhaseSpec::weight, {0.0, 1.0}, 1.0},
     {"alpha", &PhaseSpec::alpha, {0.0, 1000.0}, 1.0},
     {"radius_um", &PhaseSpec::radiusM, {1.0, 110.0}, 1e-6}}};

/// `"g": 0.85` is short for Henyey-Greenstein; `"phase"` is a name, or an object with parameters.
PhaseSpec parsePhase(const Object& entry) {
    PhaseSpec spec;
    if (entry.has("g") && entry.has("phase")) {
        throw Error({entry.where, "has both \"g\" and \"phase\"", "", "one of the two", ""});
    }
    if (entry.has("g")) {
        spec.kind = PhaseKind::henyeyGreenstein;
        spec.g = static_cast<float>(entry.number("g", kPhaseParameters[0].range));
        return spec;
    }
    const Json& phase = entry.require("phase", "the name of a phase function, or \"g\"");
    const Json named = Json::object({{"kind", phase}});
    const Object object(phase.is_string() ? named : phase, entry.where + ": phase",
                        {"kind", "g", "g2", "weight", "alpha", "radius_um", "wavelength_nm"});
    object.require("kind", "the name of a phase function");
    std::vector<std::string_view> ids;
    for (const PhaseFunction& function : phaseFunctions()) ids.push_back(function.id);
    const std::string id = object.word("kind", ids);
    spec.kind = static_cast<PhaseKind>(std::ranges::find(ids, id) - ids.begin());
    if (object.has("wavelength_nm") && spec.kind != PhaseKind::waterDroplets) {
        throw Error({object.where, fmt::format("{} has no \"wavelength_nm\"", id), "", "",
                     "remove the key"});
    }
    spec.wavelengthM =
        1e-9f * static_cast<float>(object.number("wavelength_nm", {400.0, 1000.0}, 0.0));
    for (const PhaseParameter& parameter : kPhaseParameters) {
        if (!object.has(parameter.key)) continue;
        if (!phaseReads(spec.kind, parameter.member)) {
            throw Error({object.where, fmt::format("{} has no \"{}\"", id, parameter.key), "", "",
                         "remove the key"});
        }
        spec.*parameter.member =
            static_cast<float>(object.number(parameter.key, parameter.range) * parameter.unit);
    }
    return spec;
}

/// Parses the keys that layers and columns share. `baseM` is used if the entry has no base.
Slab parseSlab(const Object& entry, double baseM) {
    Slab slab;
    slab.baseM = entry.number("base_m", {0.0, kMaxLengthM}, baseM);
    if (entry.has("thickness_m") == entry.has("top_m")) {
        throw Error({entry.where, "needs one of \"thickness_m\" and \"top_m\"",
                     entry.has("top_m") ? "both" : "none", "", ""});
    }
    slab.topM = entry.has("top_m") ? entry.number("top_m", {slab.baseM, kMaxLengthM})
                                   : slab.baseM + entry.number("thickness_m", {0.0, kMaxLengthM});
    if (slab.topM <= slab.baseM) {
        throw Error({entry.where, "has no thickness",
                     fmt::format("base {} m, top {} m", slab.baseM, slab.topM), "", ""});
    }
    if (entry.has("extinction_per_m") == entry.has("optical_depth")) {
        throw Error({entry.where, "needs one of \"extinction_per_m\" and \"optical_depth\"",
                     entry.has("optical_depth") ? "both" : "none", "", ""});
    }
    slab.extinctionPerM =
        entry.has("optical_depth")
            ? entry.number("optical_depth", {0.0, kMaxOpticalDepth}) / (slab.topM - slab.baseM)
            : entry.number("extinction_per_m", {0.0, kMaxExtinctionPerM});
    slab.albedo = entry.number("albedo", {0.0, 1.0}, 1.0);
    slab.phase = parsePhase(entry);
    return slab;
}

/// A layer without a base lies on the one before it.
Medium parseLayers(const Object& scene) {
    std::vector<Slab> slabs;
    double baseM = 0.0;
    const Json& list = scene.list("layers", kMaxRepeat);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Object entry(list[i], scene.below("layers", i),
                           {"base_m", "top_m", "thickness_m", "extinction_per_m", "optical_depth",
                            "albedo", "g", "phase"});
        slabs.push_back(parseSlab(entry, baseM));
        baseM = slabs.back().topM;
    }
    return rasterise(slabs, scene.where + ": layers");
}

/// Columns stand side by side in x, from x = 0 on.
Medium parseColumns(const Object& scene) {
    std::vector<Slab> slabs;
    double leftM = 0.0;
    const Json& list = scene.list("columns", kMaxRepeat);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Object entry(list[i], scene.below("columns", i),
                           {"base_m", "top_m", "thickness_m", "extinction_per_m", "optical_depth",
                            "albedo", "g", "phase", "width_m", "repeat"});
        Slab slab = parseSlab(entry, 0.0);
        const double widthM = entry.number("width_m", {1e-3, kMaxLengthM});
        const int repeat = entry.integer("repeat", 1, kMaxRepeat, 1);
        // One box per column, so that the cells of the grid are no wider than the columns.
        for (int n = 0; n < repeat && slabs.size() <= kMaxRepeat; ++n) {
            slab.leftM = leftM;
            slab.rightM = leftM += widthM;
            slabs.push_back(slab);
        }
    }
    return rasterise(slabs, scene.where + ": columns");
}

/// A list of so many numbers.
template <int kCount>
glm::vec<kCount, double> parseNumbers(const Object& object, std::string_view key, Range range) {
    glm::vec<kCount, double> numbers{0.0};
    const std::string expected =
        fmt::format("{} numbers from {} to {}", kCount, range.low, range.high);
    const Json& list = object.require(key, expected);
    if (!list.is_array() || list.size() != kCount)
        refuseJson(object.where, key, excerpt(list), expected);
    for (int i = 0; i < kCount; ++i) {
        const Json& item = list[static_cast<std::size_t>(i)];
        numbers[i] = item.is_number() ? item.get<double>() : -1.0;
        if (!(numbers[i] >= range.low && numbers[i] <= range.high)) {
            refuseJson(object.where, key, excerpt(list), expected);
        }
    }
    return numbers;
}

/// Extinction of a grid: inline, or from a file in `folder`.
std::vector<float> parseValues(const Object& entry, std::size_t count,
                               const std::filesystem::path& folder) {
    if (entry.has("csv") + entry.has("raw") + entry.has("values") != 1) {
        throw Error({entry.where, "needs one of \"values\", \"csv\" and \"raw\"", "", "", ""});
    }
    if (entry.has("csv")) return readCsv(folder / entry.text("csv"), count);
    if (entry.has("raw")) return readRaw(folder / entry.text("raw"), count);
    std::vector<float> values;
    for (const Json& item : entry.list("values", count)) {
        values.push_back(item.is_number() ? item.get<float>() : -1.0f);
    }
    checkExtinction(values, count, entry.where + ": values");
    return values;
}

Medium parseGrid(const Object& scene, const std::filesystem::path& folder, bool& trilinear) {
    constexpr std::size_t kMaxFields = kSpeciesCount;  // each stands in for a species
    const Object grid(*scene.find("grid"), scene.where + ": grid",
                      {"size", "spacing_m", "trilinear", "fields"});
    Medium medium;
    const glm::dvec3 size = parseNumbers<3>(grid, "size", {1.0, 2048.0});
    medium.size = glm::ivec3(size);
    if (glm::dvec3(medium.size) != size) {
        refuseJson(grid.where, "size", excerpt(*grid.find("size")), "whole numbers");
    }
    checkCellCount(medium.size, grid.where);
    medium.spacingM = parseNumbers<3>(grid, "spacing_m", {1e-3, kMaxLengthM});
    trilinear = grid.flag("trilinear", false);
    grid.require("fields", "a list");
    const Json& list = grid.list("fields", kMaxFields);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Object entry(list[i], grid.below("fields", i),
                           {"values", "csv", "raw", "scale", "albedo", "g", "phase"});
        render::MeterField field{Array3f(medium.size), entry.number("albedo", {0.0, 1.0}, 1.0),
                                 parsePhase(entry)};
        field.extinctionPerM.values =
            parseValues(entry, field.extinctionPerM.values.size(), folder);
        const auto scale = static_cast<float>(entry.number("scale", {0.0, 1e6}, 1.0));
        for (float& value : field.extinctionPerM.values) value *= scale;
        medium.fields.push_back(std::move(field));
    }
    return medium;
}

Medium parseMedium(const Object& scene, const std::filesystem::path& folder, bool& trilinear) {
    if (scene.has("layers") + scene.has("columns") + scene.has("grid") != 1) {
        throw Error({scene.where, "needs one of \"layers\", \"columns\" and \"grid\"", "", "", ""});
    }
    if (scene.has("layers")) return parseLayers(scene);
    if (scene.has("columns")) return parseColumns(scene);
    return parseGrid(scene, folder, trilinear);
}

/// Without a sun its irradiance is zero.
void parseSun(const Object& experiment, render::MeterScene& scene) {
    scene.sunIrradiance = 0.0;
    const Json* json = experiment.find("sun");
    if (json == nullptr) return;
    const Object sun(*json, experiment.where + ": sun",
                     {"zenith_deg", "azimuth_deg", "irradiance", "angular_radius_deg"});
    const double zenith = glm::radians(sun.number("zenith_deg", {0.0, 89.9}));
    const double azimuth = glm::radians(sun.number("azimuth_deg", {-360.0, 360.0}, 0.0));
    scene.towardsSun = {-std::sin(zenith) * std::cos(azimuth),
                        -std::sin(zenith) * std::sin(azimuth), std::cos(zenith)};
    scene.sunIrradiance = sun.number("irradiance", {0.0, kMaxLight}, 1.0);
    scene.sunRadiusRad = glm::radians(
        sun.number("angular_radius_deg", {0.01, 10.0}, glm::degrees(render::kSunRadiusRad)));
}

/// `"x_m": [from, to]` and `"y_m"`, both or none.
std::optional<std::array<glm::dvec2, 2>> parseArea(const Object& entry) {
    if (!entry.has("x_m") && !entry.has("y_m")) return {};
    const auto x = parseNumbers<2>(entry, "x_m", {0.0, kMaxLengthM});
    const auto y = parseNumbers<2>(entry, "y_m", {0.0, kMaxLengthM});
    if (!(x[0] < x[1] && y[0] < y[1])) {
        throw Error({entry.where, "has no area", "", "\"x_m\" and \"y_m\" that increase", ""});
    }
    return std::array{glm::dvec2(x[0], y[0]), glm::dvec2(x[1], y[1])};
}

void parseDetectors(const Object& parent, Experiment& experiment) {
    const Object detectors(parent.require("detectors", "an object in braces"),
                           parent.where + ": detectors", {"fluxes", "radiances", "per_column"});
    experiment.perColumn = detectors.flag("per_column", false);
    for (const Json& item : detectors.list("fluxes", kFluxNames.size())) {
        const Json named = Json::object({{"fluxes", item}});
        const std::string word =
            Object(named, detectors.where, {"fluxes"}).word("fluxes", kFluxNames);
        const auto place = std::ranges::find(kFluxNames, word) - kFluxNames.begin();
        experiment.fluxes.push_back(static_cast<Flux>(place));
    }
    const Json& list = detectors.list("radiances", kMaxViews);
    for (std::size_t i = 0; i < list.size(); ++i) {
        constexpr std::array<std::string_view, 2> kSides{"top", "bottom"};
        const Object entry(list[i], detectors.below("radiances", i),
                           {"name", "leaving", "zenith_deg", "azimuth_deg", "x_m", "y_m"});
        experiment.views.push_back(
            {entry.requiredText("name"), entry.word("leaving", kSides) == "top",
             entry.number("zenith_deg", {0.0, 89.9}),
             entry.number("azimuth_deg", {-360.0, 360.0}, 0.0), parseArea(entry)});
    }
}

void parseExpected(const Object& parent, Experiment& experiment) {
    constexpr std::size_t kMaxExpected = 10000;
    const Json& list = parent.list("expect", kMaxExpected);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Object entry(list[i], parent.below("expect", i),
                           {"quantity", "value", "relative", "absolute", "source"});
        const double value = entry.number("value", {-kMaxLight, kMaxLight});
        if (entry.has("relative") == entry.has("absolute")) {
            throw Error({entry.where, "needs one of \"relative\" and \"absolute\"", "", "", ""});
        }
        const double tolerance = entry.has("absolute")
                                     ? entry.number("absolute", {1e-9, kMaxLight})
                                     : entry.number("relative", {1e-6, 1.0}) * std::abs(value);
        experiment.expected.push_back(
            {entry.requiredText("quantity"), {value, tolerance, entry.text("source")}});
    }
}

Experiment parseExperiment(const Json& json, const std::string& where) {
    const Object object(json, where,
                        {"name", "sun", "sky_radiance", "surface_albedo", "detectors", "expect"});
    Experiment experiment;
    experiment.name = object.text("name");
    parseSun(object, experiment.scene);
    experiment.scene.skyRadiance = object.number("sky_radiance", {0.0, kMaxLight}, 0.0);
    if (object.has("surface_albedo")) {
        experiment.scene.surfaceAlbedo = object.number("surface_albedo", {0.0, 1.0});
    }
    if (experiment.scene.skyRadiance <= 0.0 && experiment.scene.sunIrradiance <= 0.0) {
        throw Error({where, "has no light", "", "a \"sun\" or a \"sky_radiance\"", ""});
    }
    parseDetectors(object, experiment);
    parseExpected(object, experiment);
    return experiment;
}

/// Throws Error if the fields take too much memory: every experiment has its own copy of them.
void checkMemory(const std::vector<render::MeterField>& fields, std::size_t experiments,
                 const std::string& where) {
    std::size_t values = 0;
    for (const auto& field : fields) values += field.extinctionPerM.values.size() * experiments;
    if (values <= kMaxValues) return;
    throw Error({where, "is too large",
                 fmt::format("{} values of extinction in {} experiments", values, experiments),
                 fmt::format("at most {}", kMaxValues),
                 "split the experiments into several files"});
}

}  // namespace

SceneFile parseSceneFile(std::string_view text, const std::string& where,
                         const std::filesystem::path& folder) {
    const Json document = parseStrictJson<Json>(text, where);
    checkJsonHeader(document, where, "a validation case", "nephoscope-validation-case", 1);
    const Object object(document, where,
                        {"type", "version", "name", "source", "quick", "layers", "columns", "grid",
                         "sides", "experiments"});
    SceneFile file;
    file.name = object.requiredText("name");
    file.source = object.text("source");
    file.quick = object.flag("quick", true);
    bool trilinear = false;
    Medium medium = parseMedium(object, folder, trilinear);
    file.fields = std::move(medium.fields);
    constexpr std::array<std::string_view, 2> kSides{"periodic", "open"};
    object.require("experiments", "a list");
    const Json& list = object.list("experiments", kMaxExperiments);
    checkMemory(file.fields, list.size(), where);
    for (std::size_t i = 0; i < list.size(); ++i) {
        file.experiments.push_back(parseExperiment(list[i], object.below("experiments", i)));
        render::MeterScene& scene = file.experiments.back().scene;
        scene.size = medium.size;
        scene.spacingM = medium.spacingM;
        scene.trilinear = trilinear;
        scene.periodic = object.word("sides", kSides) == "periodic";
    }
    return file;
}

SceneFile loadSceneFile(const std::filesystem::path& file) {
    return parseSceneFile(readJsonText(file, "a validation case", kMaxBytes), file.string(),
                          file.parent_path());
}

}  // namespace neph::validate
