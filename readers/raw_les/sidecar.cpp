// sidecar.cpp: parses and checks key by key. An unknown key is an error, so that a misspelt one
// does not go unnoticed.
#include "readers/raw_les/sidecar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "readers/les/levels.h"
#include "readers/shared/calendar.h"

namespace les {
namespace {

using Json = nlohmann::json;

// Limits that no model comes near; they keep sizes from overflowing.
constexpr std::size_t kMaxCells = 1U << 20U;  // along one axis
constexpr std::size_t kMaxTimes = 1'000'000;
constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 60U;

/// A value of an enumeration, and its name in the file.
template <typename Value>
struct NamedValue {
    std::string_view name;
    Value value;
};
constexpr std::array kRoles{
    NamedValue<BrickRole>{"mixing_ratio", BrickRole::mixingRatio},
    NamedValue<BrickRole>{"number_concentration", BrickRole::numberConcentration},
    NamedValue<BrickRole>{"effective_radius", BrickRole::effectiveRadius},
    NamedValue<BrickRole>{"dry_air_density", BrickRole::dryAirDensity},
    NamedValue<BrickRole>{"air_pressure", BrickRole::airPressure},
    NamedValue<BrickRole>{"air_temperature", BrickRole::airTemperature},
    NamedValue<BrickRole>{"potential_temperature", BrickRole::potentialTemperature},
    NamedValue<BrickRole>{"vapour_mixing_ratio", BrickRole::vapourMixingRatio},
    NamedValue<BrickRole>{"other", BrickRole::other},
};
constexpr std::array kSpecies{
    NamedValue<NephSpecies>{"cloud", NEPH_SPECIES_CLOUD},
    NamedValue<NephSpecies>{"ice", NEPH_SPECIES_ICE},
    NamedValue<NephSpecies>{"rain", NEPH_SPECIES_RAIN},
    NamedValue<NephSpecies>{"snow", NEPH_SPECIES_SNOW},
    NamedValue<NephSpecies>{"graupel", NEPH_SPECIES_GRAUPEL},
    NamedValue<NephSpecies>{"hail", NEPH_SPECIES_HAIL},
};
constexpr std::array kSchemes{
    NamedValue<NephMicrophysics>{"unknown", NEPH_MICROPHYSICS_UNKNOWN},
    NamedValue<NephMicrophysics>{"lin", NEPH_MICROPHYSICS_LIN},
    NamedValue<NephMicrophysics>{"wsm6", NEPH_MICROPHYSICS_WSM6},
    NamedValue<NephMicrophysics>{"thompson", NEPH_MICROPHYSICS_THOMPSON},
    NamedValue<NephMicrophysics>{"morrison", NEPH_MICROPHYSICS_MORRISON},
};

std::string shown(const Json& value) {
    return inQuotes(value.dump(-1, ' ', true, Json::error_handler_t::replace));
}

/// An object of the sidecar and its place in the file, for messages. The getters return the
/// fallback if the key is absent, and throw Error if its value is not of the right kind.
class Object {
  public:
    Object(const Json& json, std::string where, std::initializer_list<std::string_view> keys)
        : json_(json), place_(std::move(where)) {
        if (!json.is_object()) {
            throw Error{
                (place_.empty() ? std::string("the sidecar") : place_) + " is not an object",
                shown(json),
                "{ … }",
                {}};
        }
        for (const auto& [key, value] : json.items()) {
            if (std::ranges::find(keys, key) != keys.end()) continue;
            std::vector<std::string> names(keys.begin(), keys.end());
            std::string all;
            for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
            throw Error{place(key) + " is not known", inQuotes(key), all, {}};
        }
    }

    bool has(const char* key) const { return json_.contains(key); }

    const Json& require(const char* key, const char* expected) const {
        if (has(key)) return json_.at(key);
        throw Error{place(key) + " is missing", {}, expected, "docs/raw-les.md has the schema"};
    }
    [[noreturn]] void fail(const char* key, const std::string& expected) const {
        throw Error{place(key) + " has an invalid value", shown(json_.at(key)), expected, {}};
    }
    std::string text(const char* key, const char* fallback = "") const {
        if (!has(key)) return fallback;
        if (!json_.at(key).is_string()) fail(key, "a string");
        return json_.at(key).get<std::string>();
    }
    double number(const char* key, double fallback) const {
        if (!has(key)) return fallback;
        const Json& value = json_.at(key);
        if (!value.is_number() || !std::isfinite(value.get<double>())) fail(key, "a number");
        return value.get<double>();
    }
    std::vector<double> numbers(const char* key, const std::string& expected) const {
        const Json& list = require(key, expected.c_str());
        std::vector<double> values;
        if (!list.is_array()) fail(key, expected);
        for (const Json& value : list) {
            if (!value.is_number() || !std::isfinite(value.get<double>())) fail(key, expected);
            values.push_back(value.get<double>());
        }
        return values;
    }
    template <typename Value, std::size_t N>
    Value choice(const char* key, const std::array<NamedValue<Value>, N>& choices,
                 Value fallback) const {
        if (!has(key)) return fallback;
        const std::string found = text(key);
        std::string all;
        for (const NamedValue<Value>& each : choices) {
            if (each.name == found) return each.value;
            all += (all.empty() ? "" : ", ") + std::string(each.name);
        }
        fail(key, "one of " + all);
    }
    std::string place(std::string_view key) const {
        return place_.empty() ? fmt::format("key {}", key) : fmt::format("{}, key {}", place_, key);
    }

  private:
    const Json& json_;
    std::string place_;
};

void parseShape(const Object& object, Sidecar& sidecar) {
    const std::string expected = "three cell counts: x, y, z";
    const auto shape = object.numbers("shape", expected);
    if (shape.size() != 3) object.fail("shape", expected);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double n = shape[axis];
        if (n < 1.0 || n > static_cast<double>(kMaxCells) || n != std::floor(n)) {
            object.fail("shape", fmt::format("whole numbers from 1 to {}", kMaxCells));
        }
        sidecar.shape[axis] = static_cast<std::size_t>(n);
    }
}

/// Interfaces from the heights, which must be given in exactly one of three ways.
void parseLevels(const Object& object, const std::vector<double>& spacing, Sidecar& sidecar) {
    const std::size_t nz = sidecar.shape[2];
    const bool even = spacing.size() == 3;
    const bool levels = object.has("level_heights_m");
    const bool interfaces = object.has("interface_heights_m");
    if (int{even} + int{levels} + int{interfaces} != 1) {
        throw Error{"the heights of levels must be given exactly once",
                    fmt::format("{} times", int{even} + int{levels} + int{interfaces}),
                    "a third number in spacing_m, or level_heights_m, or interface_heights_m",
                    {}};
    }
    const double bottom = object.number("bottom_m", 0.0);
    if (even) {
        for (std::size_t k = 0; k <= nz; ++k) {
            sidecar.interfacesM.push_back(bottom + spacing[2] * static_cast<double>(k));
        }
    } else if (levels) {
        const std::string expected = fmt::format("{} heights of level centres, increasing", nz);
        const auto centres = object.numbers("level_heights_m", expected);
        if (centres.size() != nz) object.fail("level_heights_m", expected);
        sidecar.interfacesM = interfacesOf(centres);
    } else {
        const std::string expected = fmt::format("{} heights, increasing", nz + 1);
        sidecar.interfacesM = object.numbers("interface_heights_m", expected);
        if (sidecar.interfacesM.size() != nz + 1 ||
            std::ranges::adjacent_find(sidecar.interfacesM, std::greater_equal{}) !=
                sidecar.interfacesM.end()) {
            object.fail("interface_heights_m", expected);
        }
    }
}

/// Faces of cells that are not even, in x, y or both. They may start anywhere.
void parseEdges(const Object& object, const Json& json, Sidecar& sidecar) {
    if (!object.has("edges_m")) return;
    const Object edges(json.at("edges_m"), "key edges_m", {"x", "y"});
    constexpr std::array kAxes{"x", "y"};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (!edges.has(kAxes[axis])) continue;
        const std::string expected =
            fmt::format("{} positions in metres, increasing", sidecar.shape[axis] + 1);
        auto faces = edges.numbers(kAxes[axis], expected);
        if (faces.size() != sidecar.shape[axis] + 1) edges.fail(kAxes[axis], expected);
        startAtZero(edges.place(kAxes[axis]) + ": its positions", faces);
        sidecar.edgesM[axis] = std::move(faces);
    }
}

void parseGrid(const Object& object, const Json& json, Sidecar& sidecar) {
    parseShape(object, sidecar);
    const std::string expected =
        "metres in x and y, and in z if levels are evenly spaced; all above 0";
    const auto spacing = object.numbers("spacing_m", expected);
    if (spacing.size() < 2 || spacing.size() > 3 ||
        std::ranges::any_of(spacing, [](double d) { return !(d > 0.0 && d < 1e9); })) {
        object.fail("spacing_m", expected);
    }
    sidecar.spacingM = {spacing[0], spacing[1]};
    parseEdges(object, json, sidecar);
    parseLevels(object, spacing, sidecar);
}

/// The middle of the grid, on a map that is true in all directions from there.
void parsePlace(const Object& object, Sidecar& sidecar) {
    if (!object.has("latitude") && !object.has("longitude")) return;
    for (const char* key : {"latitude", "longitude"}) object.require(key, "both or neither");
    const double latitude = object.number("latitude", 0.0);
    const double longitude = object.number("longitude", 0.0);
    if (std::abs(latitude) > 90.0) object.fail("latitude", "degrees north, from -90 to 90");
    if (std::abs(longitude) > 360.0) object.fail("longitude", "degrees east, from -360 to 360");
    sidecar.projection =
        fmt::format("+proj=aeqd +lat_0={:.9g} +lon_0={:.9g} +ellps=WGS84", latitude, longitude);
}

/// The date is written as for a time of a model, with a Z that says UTC.
void parseDate(const Object& object, Sidecar& sidecar) {
    if (!object.has("start_utc")) return;
    const std::string text = object.text("start_utc");
    const auto seconds = shared::secondsOfDate(text);
    if (!seconds || !text.ends_with('Z') || text.size() < 16) {
        object.fail("start_utc", "a time in UTC such as \"2021-08-14T18:00:00Z\"");
    }
    sidecar.utcOfZero = shared::dateOfSeconds(*seconds) + "Z";
    sidecar.utcOfZero[10] = 'T';
}

void parseTimes(const Object& object, Sidecar& sidecar) {
    constexpr const char* kExpected = "a list of { \"label\": \"540 s\", \"seconds\": 540 }";
    const Json& list = object.require("times", kExpected);
    if (!list.is_array() || list.empty() || list.size() > kMaxTimes) {
        object.fail("times", kExpected);
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Object time(list[i], fmt::format("time {}", i), {"label", "seconds"});
        time.require("seconds", "a number");
        const double seconds = time.number("seconds", 0.0);
        const std::string label = time.text("label");
        sidecar.times.push_back(
            {label.empty() ? fmt::format("{:.9g} s", seconds) : label, seconds});
    }
}

/// Number type of a variable; `fallback` is the one that the sidecar states for all variables.
NumberType numberType(const Object& object, std::optional<NumberType> fallback) {
    constexpr const char* kTypes = "float32, float64, uint8, int16, uint16 or int32";
    if (!object.has("numbers") && fallback) return *fallback;
    object.require("numbers", kTypes);
    const auto type = numberTypeNamed(object.text("numbers"));
    if (!type) object.fail("numbers", kTypes);
    return *type;
}

/// Source of a variable's values: `file`, `files` or `profile`.
void parseFiles(const Object& object, const Json& json, const Sidecar& sidecar,
                BrickVariable& variable) {
    const bool profile = object.has("profile");
    if (int{object.has("file")} + int{object.has("files")} + int{profile} != 1) {
        throw Error{object.place("file") + " must be given exactly once",
                    {},
                    "file (all times), files (one per time) or profile (one number per level)",
                    {}};
    }
    if (profile) {
        const std::string expected = fmt::format("{} numbers", sidecar.shape[2]);
        variable.profile = object.numbers("profile", expected);
        if (variable.profile.size() != sidecar.shape[2]) object.fail("profile", expected);
        return;
    }
    if (object.has("file")) variable.files = {object.text("file")};
    if (object.has("files")) {
        const Json& list = json.at("files");
        const std::string expected = fmt::format(
            "{} names, one per time; null where the variable is zero", sidecar.times.size());
        if (!list.is_array() || list.size() != sidecar.times.size()) object.fail("files", expected);
        for (const Json& name : list) {
            if (!name.is_null() && (!name.is_string() || name.get<std::string>().empty())) {
                object.fail("files", expected);
            }
            variable.files.push_back(name.is_null() ? std::string() : name.get<std::string>());
        }
    } else if (variable.files.front().empty()) {
        object.fail("file", "a name");
    }
    const double first = object.number("first_byte", 0.0);
    if (first < 0.0 || first > static_cast<double>(kMaxBytes) || first != std::floor(first)) {
        object.fail("first_byte", "a whole number of bytes");
    }
    variable.firstByte = static_cast<std::uint64_t>(first);
}

void parseVariable(const Json& json, std::size_t index, std::optional<NumberType> numbers,
                   Sidecar& sidecar) {
    const Object object(json, fmt::format("variable {}", index),
                        {"name", "role", "species", "unit", "description", "numbers", "scale",
                         "offset", "missing", "file", "files", "first_byte", "profile"});
    BrickVariable variable;
    object.require("name", "a string");
    object.require("role", "mixing_ratio, dry_air_density …");
    variable.name = object.text("name");
    if (variable.name.empty()) object.fail("name", "a name");
    variable.unit = object.text("unit");
    variable.description = object.text("description");
    variable.role = object.choice("role", kRoles, BrickRole::other);
    variable.species = object.choice("species", kSpecies, NEPH_SPECIES_NONE);
    const bool ofSpecies = variable.role == BrickRole::mixingRatio ||
                           variable.role == BrickRole::numberConcentration ||
                           variable.role == BrickRole::effectiveRadius;
    if (ofSpecies) object.require("species", "cloud, ice, rain, snow, graupel or hail");
    if (variable.role != BrickRole::other) object.require("unit", "a string");
    parseFiles(object, json, sidecar, variable);
    if (variable.profile.empty()) variable.type = numberType(object, numbers);
    variable.scale = object.number("scale", 1.0);
    variable.offset = object.number("offset", 0.0);
    if (object.has("missing")) variable.missing = object.number("missing", 0.0);
    sidecar.variables.push_back(std::move(variable));
}

void parseVariables(const Object& object, Sidecar& sidecar) {
    std::optional<NumberType> numbers;
    if (object.has("numbers")) numbers = numberType(object, {});
    const Json& list = object.require("variables", "a list of variables");
    if (!list.is_array() || list.empty()) object.fail("variables", "a list of variables");
    for (std::size_t i = 0; i < list.size(); ++i) parseVariable(list[i], i, numbers, sidecar);
    const bool any = std::ranges::any_of(sidecar.variables, [](const BrickVariable& variable) {
        return variable.role == BrickRole::mixingRatio;
    });
    if (!any) {
        throw Error{"no variable is a hydrometeor",
                    {},
                    "at least one variable with the role mixing_ratio",
                    {}};
    }
}

/// Keys that describe the run as a whole.
void parseRun(const Object& object, const Json& json, Sidecar& sidecar) {
    sidecar.model = object.text("model", "brick");
    sidecar.scheme = object.text("scheme");
    sidecar.microphysics = object.choice("microphysics", kSchemes, NEPH_MICROPHYSICS_UNKNOWN);
    sidecar.cloudDropletsPerM3 = object.number("cloud_droplets_per_m3", 0.0);
    if (sidecar.cloudDropletsPerM3 < 0.0) object.fail("cloud_droplets_per_m3", "0 or more");
    constexpr std::array kOrders{NamedValue<bool>{"little", false}, NamedValue<bool>{"big", true}};
    object.require("byte_order", "little or big");
    sidecar.bigEndian = object.choice("byte_order", kOrders, false);
    if (!object.has("notes")) return;
    if (!json.at("notes").is_array()) object.fail("notes", "a list of sentences");
    for (const Json& note : json.at("notes")) {
        if (!note.is_string()) object.fail("notes", "a list of sentences");
        sidecar.notes.push_back(note.get<std::string>());
    }
}

}  // namespace

Sidecar parseSidecar(std::string_view text) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::exception& problem) {
        throw Error{"is not JSON", problem.what(), "a nephoscope-brick sidecar", {}};
    }
    const Object object(json, "", {"type",       "version",         "model",
                                   "scheme",     "microphysics",    "cloud_droplets_per_m3",
                                   "shape",      "spacing_m",       "edges_m",
                                   "bottom_m",   "level_heights_m", "interface_heights_m",
                                   "byte_order", "numbers",         "times",
                                   "variables",  "notes",           "latitude",
                                   "longitude",  "start_utc"});
    if (object.text("type") != "nephoscope-brick") {
        throw Error{"is JSON of another type",
                    inQuotes(object.text("type")),
                    "\"type\": \"nephoscope-brick\"",
                    {}};
    }
    object.require("version", "1");
    if (object.number("version", 0.0) != 1.0) object.fail("version", "1");
    Sidecar sidecar;
    parseRun(object, json, sidecar);
    parseGrid(object, json, sidecar);
    parsePlace(object, sidecar);
    parseDate(object, sidecar);
    parseTimes(object, sidecar);
    parseVariables(object, sidecar);
    return sidecar;
}

bool looksLikeSidecar(std::string_view text) {
    return trimmed(text.substr(0, 64)).starts_with('{') &&
           text.substr(0, 4096).find("nephoscope-brick") != std::string_view::npos;
}

}  // namespace les
