// grid.cpp: map scale factors. WRF's cells are DX / MAPFAC_M wide on the earth.
#include "readers/wrf_netcdf/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "readers/wrf_netcdf/term.h"

namespace wrf {
namespace {

constexpr double kMetresPerDegree = kEarthRadiusM * std::numbers::pi / 180.0;
// Larger spacings in degrees, and smaller ones in metres, do not occur on latitude-longitude grids.
constexpr double kMostDegrees = 10.0;
// Cells of any model, or of any grid in degrees.
constexpr double kLeastM = 1e-3, kMostM = 1e6;
// Distances by latitudes are those of a sphere and of floats.
constexpr double kSameDistance = 0.1;

/// Mean, least and greatest width of cells as shares of DX. The mean is that of areas.
struct Widths {
    double mean = 1.0, least = 1.0, greatest = 1.0;
};

/// Widths by map scale factors; nothing if there are none or they are not above zero, as in
/// idealised runs.
std::optional<Widths> widthsOf(const std::vector<float>& factors) {
    if (factors.empty()) return {};
    Widths widths{0.0, 1e30, 0.0};
    for (const float factor : factors) {
        if (!(factor > 0.01f) || !(factor < 100.0f)) return {};
        const double width = 1.0 / static_cast<double>(factor);
        widths.mean += width * width;
        widths.least = std::min(widths.least, width);
        widths.greatest = std::max(widths.greatest, width);
    }
    widths.mean = std::sqrt(widths.mean / static_cast<double>(factors.size()));
    return widths;
}

/// Step of a coordinate of the axis in metres, where it is even; nothing otherwise.
std::optional<double> stepOfCoordinate(const Tiles& tiles, std::size_t axis) {
    const NcVariable* variable = tiles.first().variable(tiles.axes().centre[axis]);
    if (variable == nullptr || !variable->number || variable->axes.size() != 1) return {};
    const auto toMetres = shared::conversion(variable->units, "m");
    const std::array<std::size_t, 1> start{0}, count{variable->axes[0].length};
    if (!toMetres || count[0] < 2) return {};
    const auto positions = tiles.first().readDoubles(*variable, start, count);
    const double step =
        (positions.back() - positions.front()) / static_cast<double>(positions.size() - 1);
    for (std::size_t i = 1; i < positions.size(); ++i) {
        if (!(std::abs(positions[i] - positions[i - 1] - step) <= 1e-3 * std::abs(step))) return {};
    }
    return toMetres->scale * step;
}

/// Mean distance of neighbouring columns by XLAT and XLONG; nothing if these are not there.
std::optional<double> stepOfLatitudes(const Tiles& tiles, std::size_t axis) {
    const auto latitude = flatField(tiles, "XLAT");
    const auto longitude = flatField(tiles, "XLONG");
    const auto columns = tiles.columns();
    if (latitude.empty() || longitude.empty() || columns[axis] < 2) return {};
    const std::size_t y = axis == 0 ? columns[1] / 2 : 0;
    const std::size_t x = axis == 0 ? 0 : columns[0] / 2;
    const std::size_t from = y * columns[0] + x;
    const std::size_t to = axis == 0 ? from + 1 : from + columns[0];
    const double rad = std::numbers::pi / 180.0;
    const double north = static_cast<double>(latitude[to] - latitude[from]);
    const double east = static_cast<double>(longitude[to] - longitude[from]) *
                        std::cos(static_cast<double>(latitude[from]) * rad);
    const double metres = kMetresPerDegree * std::hypot(north, east);
    if (!(metres > 0.0)) return {};
    return metres;
}

/// Length of a degree of longitude in the mean, as a share of that at the equator; 1 where a map
/// scale factor says it, or no latitude is there.
double shareOfEquator(const Tiles& tiles) {
    if (!flatField(tiles, "MAPFAC_MX").empty()) return 1.0;
    const auto latitude = flatField(tiles, "XLAT");
    if (latitude.empty()) return 1.0;
    double sum = 0.0;
    for (const float degrees : latitude) {
        sum += std::cos(static_cast<double>(degrees) * std::numbers::pi / 180.0);
    }
    return sum / static_cast<double>(latitude.size());
}

/// A note and a corrected width where columns are further apart than DX says, as in a file of which
/// every other column was kept.
void compareWithDistance(const Tiles& tiles, std::size_t axis, double& spacing,
                         std::vector<std::string>& notes) {
    auto distance = stepOfCoordinate(tiles, axis);
    if (!distance) distance = stepOfLatitudes(tiles, axis);
    if (!distance) return;
    const double ratio = std::abs(*distance) / spacing;
    if (std::abs(ratio - 1.0) <= kSameDistance) return;
    const double whole = std::round(ratio);
    const char* name = axis == 0 ? "DX" : "DY";
    if (whole >= 2.0 && std::abs(ratio - whole) <= kSameDistance * whole) {
        notes.push_back(
            fmt::format("Columns are {:.0f} times {} apart, as if others were left out: "
                        "cells are taken as {:.6g} m.",
                        whole, name, whole * spacing));
        spacing *= whole;
        return;
    }
    notes.push_back(fmt::format("{} gives cells of {:.6g} m, but coordinates say {:.6g} m.", name,
                                spacing, std::abs(*distance)));
}

struct Spacing {
    double metres = 0.0;
    bool fromAttribute = false;
};

/// DX or DY in metres before map scale factors.
Spacing nominalSpacing(const Tiles& tiles, std::size_t axis, std::vector<std::string>& notes) {
    const char* name = axis == 0 ? "DX" : "DY";
    const NcFile& file = tiles.first();
    const auto stated = file.number(name);
    if (stated && *stated >= kLeastM && *stated <= kMostM) {
        const bool degrees =
            file.number("MAP_PROJ").value_or(0.0) == kLatitudeLongitude && *stated < kMostDegrees;
        if (!degrees) return {*stated, true};
        const double share = axis == 0 ? shareOfEquator(tiles) : 1.0;
        const double metres = *stated * kMetresPerDegree * share;
        notes.push_back(fmt::format("{} of {:g} is taken as degrees: {:.0f} m{}.", name, *stated,
                                    metres, share < 1.0 ? " at the mean latitude" : ""));
        return {metres, true};
    }
    if (!stated) {
        const char* from = "the coordinate of the axis";
        auto step = stepOfCoordinate(tiles, axis);
        if (!step) {
            step = stepOfLatitudes(tiles, axis);
            from = "XLAT and XLONG";
        }
        if (step && *step >= kLeastM && *step <= kMostM) {
            notes.push_back(fmt::format("The attribute {} is missing: {:.6g} m by {} instead.",
                                        name, *step, from));
            return {*step, false};
        }
    }
    throw Failure{fmt::format("global attribute {} (grid spacing) is {}", name,
                              stated ? "not a length" : "missing"),
                  stated ? fmt::format("{}", *stated) : "", "metres, above zero",
                  "copy the global attributes from the original wrfout (ncks -A)"};
}

std::string rangeText(const Widths& widths) {
    const double least = 1.0 / widths.greatest;
    const double greatest = 1.0 / widths.least;
    return fmt::format("{:.4g}", least) == fmt::format("{:.4g}", greatest)
               ? fmt::format("{:.4g}", greatest)
               : fmt::format("{:.4g} to {:.4g}", least, greatest);
}

/// Divides by the mean map scale factor, where the file has one.
void applyMapFactors(const Tiles& tiles, std::array<double, 2>& spacing,
                     std::vector<std::string>& notes) {
    std::array<std::optional<Widths>, 2> widths{widthsOf(flatField(tiles, "MAPFAC_MX")),
                                                widthsOf(flatField(tiles, "MAPFAC_MY"))};
    if (!widths[0] || !widths[1]) {
        widths[0] = widths[1] = widthsOf(flatField(tiles, "MAPFAC_M"));
    }
    if (!widths[0]) {
        const bool there = !flatField(tiles, "MAPFAC_M").empty();
        notes.push_back(
            fmt::format("MAPFAC_M {}: cells are taken as DX by DY, without the map scale "
                        "factor.",
                        there ? "has impossible values" : "is missing"));
        return;
    }
    double deviation = 0.0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const Widths& own = *widths[axis];
        spacing[axis] *= own.mean;
        deviation =
            std::max({deviation, own.greatest / own.mean - 1.0, 1.0 - own.least / own.mean});
    }
    const bool same = rangeText(*widths[0]) == rangeText(*widths[1]);
    notes.push_back(fmt::format(
        "Map scale factors are {}{}, the largest {:.4g}: cells are taken as {:.6g} x {:.6g} m "
        "everywhere, their mean on the earth, from which they differ by up to {:.2g} %.",
        rangeText(*widths[0]), same ? "" : " in x and " + rangeText(*widths[1]) + " in y",
        std::max(1.0 / widths[0]->least, 1.0 / widths[1]->least), spacing[0], spacing[1],
        1e2 * deviation));
}

/// Latitude or longitude of the south-west corner at a record; nothing if it is not there or 0, as
/// in idealised runs.
std::optional<double> cornerOf(const Tiles& tiles, const char* name, std::size_t record) {
    const NcVariable* variable = tiles.first().variable(name);
    const auto shape = variable == nullptr ? std::nullopt : tiles.shapeOf(*variable);
    if (!shape || !shape->flat || !variable->number) return {};
    float value = 0.0f;
    tiles.read(*variable, record, Box{{0, 0, 0}, {1, 1, 1}}, {&value, 1});
    if (!std::isfinite(value) || value == 0.0f) return {};
    return static_cast<double>(value);
}

}  // namespace

std::vector<float> flatField(const Tiles& tiles, const char* name) {
    const NcVariable* variable = tiles.first().variable(name);
    if (variable == nullptr || !variable->number) return {};
    const auto shape = tiles.shapeOf(*variable);
    if (!shape || !shape->flat || shape->staggered[0] || shape->staggered[1]) return {};
    const auto columns = tiles.columns();
    std::vector<float> values(columns[0] * columns[1]);
    tiles.read(*variable, 0, Box{{0, 0, 0}, {columns[0], columns[1], 1}}, values);
    return values;
}

std::array<double, 2> spacingOf(const Tiles& tiles, std::vector<std::string>& notes) {
    const std::array nominal{nominalSpacing(tiles, 0, notes), nominalSpacing(tiles, 1, notes)};
    std::array<double, 2> spacing{nominal[0].metres, nominal[1].metres};
    const auto projection = tiles.first().number("MAP_PROJ");
    if (!nominal[0].fromAttribute || !nominal[1].fromAttribute) return spacing;
    const bool mapped = projection ? *projection != 0.0 : !flatField(tiles, "MAPFAC_M").empty();
    if (mapped) applyMapFactors(tiles, spacing, notes);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        compareWithDistance(tiles, axis, spacing[axis], notes);
    }
    if (tiles.flipsRows()) {
        notes.push_back("Rows are stored from north to south: they are turned.");
    }
    return spacing;
}

std::string motionNote(const Tiles& tiles, std::size_t first, std::size_t last, bool placed) {
    constexpr double kMovedDegrees = 1e-3;
    for (const char* name : {"XLAT", "XLONG"}) {
        const auto before = cornerOf(tiles, name, first);
        const auto after = cornerOf(tiles, name, last);
        if (before && after && std::abs(*after - *before) > kMovedDegrees) {
            return fmt::format(
                "The domain moves between the times of the file (its corner from {:.3f} "
                "to {:.3f} in {}): {}.",
                *before, *after, name,
                placed ? "each time has its own place, and the camera follows the grid unless it "
                         "is fixed to the ground"
                       : "each time is shown from its own corner, and where it lies is not known");
        }
    }
    return {};
}

std::string domainOf(const Tiles& tiles, bool mayMove) {
    const NcFile& file = tiles.first();
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    const auto id = file.number("GRID_ID");
    if (id) add(fmt::format("domain {:.0f}", *id));
    auto start = file.text("SIMULATION_START_DATE");
    if (!start) start = file.text("START_DATE");
    if (mayMove && start && id && *id > 1.0) return text + " of the run from " + *start;
    const auto latitude = file.number("CEN_LAT");
    const auto longitude = file.number("CEN_LON");
    if (latitude && longitude) {
        add(fmt::format("centre {:.3f} N {:.3f} E", *latitude, *longitude));
    }
    const auto i = file.number("I_PARENT_START");
    const auto j = file.number("J_PARENT_START");
    if (i && j && (*i > 1.0 || *j > 1.0)) {
        add(fmt::format("corner at {:.0f}, {:.0f} of its parent", *i, *j));
    }
    const auto cornerLatitude = cornerOf(tiles, "XLAT", 0);
    const auto cornerLongitude = cornerOf(tiles, "XLONG", 0);
    if (cornerLatitude && cornerLongitude) {
        add(fmt::format("corner {:.2f} N {:.2f} E", *cornerLatitude, *cornerLongitude));
    }
    return text;
}

void numberDomain(const NcFile& file, neph::plugin::Description& description) {
    constexpr double kMost = 1 << 20;
    const auto whole = [&](const char* name) {
        const auto value = file.number(name);
        const bool possible = value && *value >= 0.0 && *value <= kMost;
        return possible ? static_cast<int>(std::lround(*value)) : 0;
    };
    description.domainNumber = static_cast<unsigned>(whole("GRID_ID"));
    const int parent = whole("PARENT_ID");
    // Namelists may call the outermost domain its own parent.
    if (parent == static_cast<int>(description.domainNumber)) return;
    description.parentNumber = static_cast<unsigned>(parent);
    const int i = whole("I_PARENT_START"), j = whole("J_PARENT_START");
    if (description.parentNumber == 0 || i < 1 || j < 1) return;
    description.parentCorner = {i - 1, j - 1};  // counted from 1
    description.parentRatio = static_cast<unsigned>(whole("PARENT_GRID_RATIO"));
}

}  // namespace wrf
