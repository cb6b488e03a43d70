// map_grid.h: how a grid lies on the earth, in plain values.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "core/base/utc_time.h"

namespace neph {

/// How a grid lies on a map, as the reader of its data states it.
struct MapGrid {
    std::string projection;      ///< PROJ string of a projection to metres; empty: not known
    glm::dvec2 originM{0.0};     ///< of the grid's south-west corner on the map
    glm::dvec2 mapPerGrid{1.0};  ///< metres on the map per metre of the grid, in x and y
    bool operator==(const MapGrid&) const = default;
};

struct GeoPoint {
    double latitudeDeg = 0.0;   ///< north
    double longitudeDeg = 0.0;  ///< east, -180 to 180
    bool operator==(const GeoPoint&) const = default;
};

/// "35.22 N 97.44 W".
std::string geoText(const GeoPoint& point);

/// A position of the grid on the earth.
struct PlacePoint {
    GeoPoint geo;
    /// Azimuth of true north in the frame of the grid, clockwise from its y axis: azimuth in the
    /// grid = true azimuth + convergence. WRF: atan2(SINALPHA, COSALPHA).
    double convergenceDeg = 0.0;
    /// Metres on the map per metre on the earth, in x and y. WRF: MAPFAC_MX, MAPFAC_MY.
    glm::dvec2 mapFactor{1.0};
};

/// What data say of where and when a scene is, and in what air.
struct Whereabouts {
    std::optional<PlacePoint> place;
    std::optional<UtcTime> utc;
    /// Of the lowest air, 0 to 1; where a look asks for it and the data have it.
    std::optional<double> humidity = {};
    /// Of the aerosol in it at 550 nm, 1/m; where the humidity is asked for and the data have both.
    std::optional<double> aerosolPerM = {};
};

}  // namespace neph
