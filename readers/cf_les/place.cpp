// place.cpp: grid mappings of CF (Conventions 1.11, appendix F) as PROJ strings, and the places
// that models state in attributes of their own.
#include "readers/cf_les/place.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cf {
namespace {

constexpr double kMostDegrees = 360.0;

/// A parameter of a mapping: its name in CF and in PROJ.
struct Parameter {
    const char* cf;
    const char* proj;
    double most;  ///< of its size; larger is damaged
};
constexpr double kMostMetres = 1e9;
constexpr std::array kParameters{
    Parameter{"latitude_of_projection_origin", "lat_0", 90.0},
    Parameter{"longitude_of_projection_origin", "lon_0", kMostDegrees},
    Parameter{"longitude_of_central_meridian", "lon_0", kMostDegrees},
    Parameter{"straight_vertical_longitude_from_pole", "lon_0", kMostDegrees},
    Parameter{"scale_factor_at_projection_origin", "k_0", 10.0},
    Parameter{"scale_factor_at_central_meridian", "k_0", 10.0},
    Parameter{"false_easting", "x_0", kMostMetres},
    Parameter{"false_northing", "y_0", kMostMetres},
    Parameter{"earth_radius", "R", kMostMetres},
    Parameter{"semi_major_axis", "a", kMostMetres},
    Parameter{"inverse_flattening", "rf", 1e6},
};

struct Mapping {
    const char* cf;
    const char* proj;
    const char* parallels[2];  ///< how PROJ calls the standard parallels
};
constexpr std::array kMappings{
    Mapping{"transverse_mercator", "tmerc", {nullptr, nullptr}},
    Mapping{"lambert_conformal_conic", "lcc", {"lat_1", "lat_2"}},
    Mapping{"albers_conical_equal_area", "aea", {"lat_1", "lat_2"}},
    Mapping{"lambert_azimuthal_equal_area", "laea", {nullptr, nullptr}},
    Mapping{"azimuthal_equidistant", "aeqd", {nullptr, nullptr}},
    Mapping{"mercator", "merc", {"lat_ts", nullptr}},
    Mapping{"polar_stereographic", "stere", {"lat_ts", nullptr}},
    Mapping{"stereographic", "stere", {nullptr, nullptr}},
};

/// The mapping that a hydrometeor names, else the first there is; null if there is none.
const nc::NcVariable* mappingOf(const FileSet& files) {
    const nc::NcFile& file = files.main();
    for (const Stored& each : files.variables()) {
        if (each.name == nullptr || each.name->meaning != Meaning::hydrometeor) continue;
        const std::string name = file.text(*each.variable, "grid_mapping").value_or("");
        if (!name.empty()) return named(file, name);
    }
    for (const nc::NcVariable& variable : file.variables()) {
        if (file.text(variable, "grid_mapping_name")) return &variable;
    }
    return nullptr;
}

struct Degrees {
    double latitude, longitude;
};

/// Two attributes in degrees; nothing unless both are there and possible.
std::optional<Degrees> degreesOf(const nc::NcFile& file, const char* latitude,
                                 const char* longitude) {
    const auto north = file.number(latitude), east = file.number(longitude);
    if (!north || !east || !(std::abs(*north) <= 90.0) || !(std::abs(*east) <= kMostDegrees)) {
        return {};
    }
    return Degrees{*north, *east};
}

/// A map on which x runs east and y north around a place.
std::string localMap(const Degrees& place) {
    return fmt::format("+proj=tmerc +lat_0={:.9g} +lon_0={:.9g} +ellps=WGS84", place.latitude,
                       place.longitude);
}

void addDate(const nc::NcFile& file, const Times& times, neph::plugin::Description& description) {
    if (times.dated && times.gregorian) {
        description.utcOfZero = "0001-01-01T00:00:00Z";
        return;
    }
    std::array<double, 6> date{};
    constexpr std::array kNames{"year", "month", "day", "hour", "minute", "second"};
    constexpr std::array<double, 6> kLeast{1, 1, 1, 0, 0, 0}, kMost{9999, 12, 31, 23, 59, 59};
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const auto number = file.number(kNames[i]);
        if (!number && i < 4) return;
        date[i] = std::floor(number.value_or(0.0));
        if (!(date[i] >= kLeast[i] && date[i] <= kMost[i])) return;
    }
    description.utcOfZero = fmt::format("{:04.0f}-{:02.0f}-{:02.0f}T{:02.0f}:{:02.0f}:{:02.0f}Z",
                                        date[0], date[1], date[2], date[3], date[4], date[5]);
}

void addStated(const nc::NcFile& file, const Grid& grid, neph::plugin::Description& description) {
    if (const auto centre = degreesOf(file, "ctrlat", "ctrlon")) {
        description.projection = localMap(*centre);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto& edges = grid.edgesM[axis];
            const double extentM = edges.empty()
                                       ? grid.spacingM[axis] * static_cast<double>(grid.size[axis])
                                       : edges.back();
            description.mapOriginM[axis] = -0.5 * extentM;
        }
        description.notes.emplace_back(
            "Place and date are nominal: ctrlat, ctrlon and the date are those of CM1's namelist, "
            "which radiation and the Coriolis force use, and an idealised run leaves as they are.");
        return;
    }
    const auto corner = degreesOf(file, "origin_lat", "origin_lon");
    if (!corner) return;
    if (std::abs(file.number("rotation_angle").value_or(0.0)) > 1e-6) {
        description.notes.emplace_back(
            "The place on the earth is not used: the grid is turned (rotation_angle).");
        return;
    }
    description.projection = localMap(*corner);
    description.mapOriginM = {0.0, 0.0};
}

}  // namespace

std::string projectionOf(const nc::NcFile& file, const nc::NcVariable& mapping,
                         std::vector<std::string>& notes) {
    const std::string name = file.text(mapping, "grid_mapping_name").value_or("");
    const auto known =
        std::ranges::find_if(kMappings, [&](const Mapping& each) { return name == each.cf; });
    if (known == kMappings.end()) {
        notes.push_back(
            fmt::format("The place on the earth is not known: the grid mapping \"{}\" "
                        "of {} is none to metres that can be used.",
                        name, mapping.name));
        return {};
    }
    std::string text = fmt::format("+proj={}", known->proj);
    bool sized = false;
    for (const Parameter& parameter : kParameters) {
        const std::vector<double> values = file.numbers(mapping, parameter.cf);
        if (values.size() != 1 || !(std::abs(values[0]) <= parameter.most)) continue;
        const bool size =
            std::string_view(parameter.proj) == "R" || std::string_view(parameter.proj) == "a";
        if (size && (sized || !(values[0] > 0.0))) continue;
        sized = sized || size;
        if (text.find(fmt::format("+{}=", parameter.proj)) != std::string::npos) continue;
        text += fmt::format(" +{}={:.12g}", parameter.proj, values[0]);
    }
    const std::vector<double> parallels = file.numbers(mapping, "standard_parallel");
    for (std::size_t i = 0; i < 2; ++i) {
        if (known->parallels[i] == nullptr || parallels.empty()) continue;
        const double degrees = parallels[std::min(i, parallels.size() - 1)];
        if (std::abs(degrees) <= 90.0) {
            text += fmt::format(" +{}={:.12g}", known->parallels[i], degrees);
        }
    }
    return text + (sized ? "" : " +ellps=WGS84");
}

void addPlace(const FileSet& files, const Grid& grid, const Times& times,
              neph::plugin::Description& description) {
    const nc::NcFile& file = files.main();
    addDate(file, times, description);
    if (const nc::NcVariable* mapping = mappingOf(files)) {
        description.projection = projectionOf(file, *mapping, description.notes);
        description.mapOriginM = grid.cornerM;
        return;
    }
    addStated(file, grid, description);
}

}  // namespace cf
