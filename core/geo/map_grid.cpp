// map_grid.cpp: places as text.
#include "core/geo/map_grid.h"

#include <fmt/format.h>

#include <cmath>

namespace neph {

std::string geoText(const GeoPoint& point) {
    return fmt::format("{:.2f} {} {:.2f} {}", std::abs(point.latitudeDeg),
                       point.latitudeDeg < 0.0 ? 'S' : 'N', std::abs(point.longitudeDeg),
                       point.longitudeDeg < 0.0 ? 'W' : 'E');
}

}  // namespace neph
