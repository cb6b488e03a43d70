// grid.h: the horizontal grid of a field: its size, the order of its points, its place on the
// earth.
#pragma once
#include <array>
#include <string>

#include "readers/grib/bytes.h"

namespace grib {

/// How points follow each other in a field: flag table 3.4.
struct ScanOrder {
    bool westward = false;     ///< points of a row run from east to west
    bool northward = false;    ///< rows run from south to north
    bool alongY = false;       ///< neighbouring values lie along y
    bool alternating = false;  ///< every other row (or column) runs the opposite way
};

struct Grid {
    std::array<std::size_t, 2> size{};  ///< points in x and y
    ScanOrder order;
    bool windsAlongGrid = false;  ///< u and v are along x and y, not east and north: flag table 3.3
    std::array<double, 2> spacingM{};  ///< mean width of cells on the earth
    /// In the terms of NephDescription; x runs east, y north.
    std::string projection;
    std::array<double, 2> mapOriginM{}, mapPerGrid{1.0, 1.0};
    std::string name;  ///< "lambert conformal, first point 21.138 N 237.280 E"
    std::string note;  ///< how the width of cells follows
};

/// The grid of section 3. Throws Failure for a grid that is no even one of rows and columns, with
/// the step that makes one of it.
Grid gridOf(ByteSpan section);

}  // namespace grib
