// info_place.h: where on the earth and when a series is, and where the sun stands there.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/info/info_findings.h"
#include "core/geo/map_grid.h"
#include "core/sky/solar_position.h"

namespace neph {

/// Place of a grid: its middle, its corners and its map.
struct PlaceSummary {
    PlacePoint middle;
    std::array<std::optional<GeoPoint>, 4>
        corners{};  ///< south-west, south-east, north-east, -west
    double leastMapFactor = 1.0, greatestMapFactor = 1.0;  ///< in x or y
};
/// Nothing where the place is not known.
std::optional<PlaceSummary> summarisePlace(const DatasetInfo& info);

/// The sun over the middle of the grid, wherever that lies at a time; nothing without a place and a
/// date.
std::optional<SolarPosition> sunAt(const DatasetInfo& info, int time);
/// The grid's south-west corner at a time; nothing without a place.
std::optional<GeoPoint> cornerAt(const DatasetInfo& info, int time);

/// Lines for people: place, map and date.
std::string placeLines(const DatasetInfo& info);
/// Where the grid's corner lies at each time, of a grid that moves; else empty.
std::string motionLines(const DatasetInfo& info);
/// Elevation and azimuth of the sun at each time that was read; empty if none is known.
std::string sunLines(const DatasetInfo& info, const std::vector<TimeSummary>& summaries);

}  // namespace neph
