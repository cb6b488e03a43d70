// place.cpp: a grid that is even on the map is laid through the places of its cells.
//
// WRF's maps are those of share/module_llxy.F, on a sphere of 6370 km. Origin and step are fitted
// to XLAT and XLONG, which also shows whether the attributes are those of this grid.
#include "readers/wrf_netcdf/place.h"

#include <fmt/format.h>
#include <proj.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "readers/wrf_netcdf/grid.h"

namespace wrf {
namespace {

constexpr int kLambert = 1, kPolar = 2, kMercator = 3;  // of MAP_PROJ

/// Why a file has no place.
struct Unplaced {
    std::string reason;
};

/// An angle among the attributes, in degrees; nothing if it is missing or a fill value.
std::optional<double> angleOf(const NcFile& file, const char* name, double most) {
    const auto value = file.number(name);
    if (!value || !(std::abs(*value) <= most)) return {};
    return value;
}

double requiredAngle(const NcFile& file, const char* name, double most) {
    if (const auto value = angleOf(file, name, most)) return *value;
    const auto found = file.number(name);
    throw Unplaced{fmt::format("attribute {} is {}", name,
                               found ? fmt::format("{:g}", *found) : std::string("missing"))};
}

std::string lambert(const NcFile& file) {
    constexpr double kSameLatitude = 0.1;  // of lc_cone: the cone then touches at one
    const double first = requiredAngle(file, "TRUELAT1", 89.9);
    double second = angleOf(file, "TRUELAT2", 89.9).value_or(first);
    if (std::abs(first - second) <= kSameLatitude) second = first;
    return fmt::format("+proj=lcc +lat_1={0:.9g} +lat_2={1:.9g} +lat_0={0:.9g} +lon_0={2:.9g}",
                       first, second, requiredAngle(file, "STAND_LON", 360.0));
}

std::string polar(const NcFile& file) {
    const double trueLatitude = requiredAngle(file, "TRUELAT1", 90.0);
    return fmt::format("+proj=stere +lat_0={} +lat_ts={:.9g} +lon_0={:.9g}",
                       trueLatitude < 0.0 ? -90 : 90, trueLatitude,
                       requiredAngle(file, "STAND_LON", 360.0));
}

/// Of rotate_coords: geographic longitude is counted from -STAND_LON, and the rotated pole lies at
/// POLE_LON of the turned sphere.
std::string latitudeLongitude(const NcFile& file, double middleLongitudeDeg) {
    const double poleLatitude = angleOf(file, "POLE_LAT", 90.0).value_or(90.0);
    if (std::abs(poleLatitude) == 90.0) {
        return fmt::format("+proj=eqc +lon_0={:.9g}", middleLongitudeDeg);
    }
    return fmt::format("+proj=ob_tran +o_proj=eqc +o_lat_p={:.9g} +o_lon_p={:.9g} +lon_0={:.9g}",
                       poleLatitude, requiredAngle(file, "POLE_LON", 360.0),
                       -requiredAngle(file, "STAND_LON", 360.0));
}

/// The PROJ string of Lambert, polar stereographic, Mercator, latitude and longitude, or these with
/// a rotated pole. Longitudes are counted from `middleLongitudeDeg`, that of the domain. Throws
/// Unplaced.
std::string projectionOf(const NcFile& file, double middleLongitudeDeg) {
    const auto number = file.number("MAP_PROJ");
    if (!number) throw Unplaced{"the attribute MAP_PROJ is missing"};
    std::string projection;
    if (*number == kLambert) projection = lambert(file);
    if (*number == kPolar) projection = polar(file);
    if (*number == kMercator) {
        projection = fmt::format("+proj=merc +lat_ts={:.9g} +lon_0={:.9g}",
                                 requiredAngle(file, "TRUELAT1", 89.9), middleLongitudeDeg);
    }
    if (*number == kLatitudeLongitude) projection = latitudeLongitude(file, middleLongitudeDeg);
    if (projection.empty()) {
        throw Unplaced{fmt::format("the map projection MAP_PROJ {:g} is not known here", *number)};
    }
    return projection + fmt::format(" +R={:.0f} +units=m", kEarthRadiusM);
}

/// A projection of PROJ.
class Map {
  public:
    explicit Map(const std::string& projection) : context_(proj_context_create()) {
        proj_log_func(context_, nullptr, [](void*, int, const char*) {});
        map_ = proj_create(context_, projection.c_str());
        if (map_ == nullptr) {
            proj_context_destroy(context_);
            throw Unplaced{"the attributes make no map projection (" + projection + ")"};
        }
    }
    ~Map() {
        proj_destroy(map_);
        proj_context_destroy(context_);
    }
    Map(const Map&) = delete;
    Map& operator=(const Map&) = delete;

    /// Metres on the map; not finite for what it does not show.
    std::array<double, 2> metres(double latitudeDeg, double longitudeDeg) const {
        const PJ_COORD geo = proj_coord(proj_torad(longitudeDeg), proj_torad(latitudeDeg), 0, 0);
        const PJ_COORD at = proj_trans(map_, PJ_FWD, geo);
        return {at.xy.x, at.xy.y};
    }

  private:
    PJ_CONTEXT* context_;
    PJ* map_ = nullptr;
};

/// Places of cells, x fastest.
struct Cells {
    std::vector<float> latitudeDeg, longitudeDeg;
    std::array<std::size_t, 2> columns{};

    bool empty() const { return latitudeDeg.empty() || longitudeDeg.empty(); }
    /// Whether a coordinate that must change from cell to cell has one value.
    bool areOne() const {
        const auto same = [](const std::vector<float>& values) {
            return std::ranges::all_of(values, [&](float v) { return v == values.front(); });
        };
        return (columns[1] > 1 && same(latitudeDeg)) || (columns[0] > 1 && same(longitudeDeg));
    }
    std::size_t middle() const { return columns[1] / 2 * columns[0] + columns[0] / 2; }
};

/// A line through positions along one axis: metres = origin + step · (cell + 1/2).
class Line {
  public:
    void add(double cell, double metres) {
        ++count_;
        cells_ += cell;
        metres_ += metres;
        squares_ += cell * cell;
        products_ += cell * metres;
    }
    /// `stepM` is taken where all cells are one.
    void fit(double stepM) {
        const double spread = squares_ - cells_ * cells_ / count_;
        step = spread > 0.0 ? (products_ - cells_ * metres_ / count_) / spread : stepM;
        origin = (metres_ - step * cells_) / count_ - 0.5 * step;
    }
    double at(double cell) const { return origin + step * (cell + 0.5); }
    bool empty() const { return count_ == 0.0; }

    double origin = 0.0, step = 0.0;

  private:
    double count_ = 0.0, cells_ = 0.0, metres_ = 0.0, squares_ = 0.0, products_ = 0.0;
};

/// Calls `visit` with x and y of some cells, those of the edges among them.
template <typename Visit>
void forSome(const std::array<std::size_t, 2>& columns, Visit visit) {
    constexpr std::size_t kMost = 48;  // along an axis
    std::array<std::size_t, 2> count{};
    for (std::size_t axis = 0; axis < 2; ++axis) count[axis] = std::min(columns[axis], kMost);
    const auto place = [&](std::size_t axis, std::size_t i) {
        return count[axis] < 2 ? 0 : i * (columns[axis] - 1) / (count[axis] - 1);
    };
    for (std::size_t j = 0; j < count[1]; ++j) {
        for (std::size_t i = 0; i < count[0]; ++i) visit(place(0, i), place(1, j));
    }
}

/// Steps on the map, metres, by DX and DY; without them those of the grid.
std::array<double, 2> nominalStepsM(const NcFile& file, std::array<double, 2> stepsM) {
    constexpr double kMostAsideDegrees = 10.0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto stated = file.number(axis == 0 ? "DX" : "DY");
        if (!stated || !(*stated > 0.0)) continue;
        const bool degrees =
            file.number("MAP_PROJ") == kLatitudeLongitude && *stated < kMostAsideDegrees;
        stepsM[axis] = degrees ? *stated * kEarthRadiusM * std::numbers::pi / 180.0 : *stated;
    }
    return stepsM;
}

/// Lays the grid through its cells. Throws Unplaced if they do not lie on it.
std::array<Line, 2> fitted(const Map& map, const Cells& cells, const NcFile& file,
                           const std::array<double, 2>& stepsM) {
    constexpr double kMostCells = 0.5,
                     kMostAsideM = 200.0;  // single precision misses by some metres
    const auto onMap = [&](std::size_t x, std::size_t y) {
        const std::size_t cell = y * cells.columns[0] + x;
        return map.metres(static_cast<double>(cells.latitudeDeg[cell]),
                          static_cast<double>(cells.longitudeDeg[cell]));
    };
    const auto isThere = [](const std::array<double, 2>& at) {
        return std::isfinite(at[0]) && std::isfinite(at[1]);
    };
    std::array<Line, 2> lines;
    forSome(cells.columns, [&](std::size_t x, std::size_t y) {
        const auto at = onMap(x, y);
        if (!isThere(at)) return;
        lines[0].add(static_cast<double>(x), at[0]);
        lines[1].add(static_cast<double>(y), at[1]);
    });
    if (lines[0].empty()) throw Unplaced{"XLAT and XLONG have no values on its map"};
    for (std::size_t axis = 0; axis < 2; ++axis) lines[axis].fit(stepsM[axis]);
    double worstM = 0.0;
    forSome(cells.columns, [&](std::size_t x, std::size_t y) {
        const auto at = onMap(x, y);
        if (!isThere(at)) return;
        worstM = std::max(worstM, std::hypot(at[0] - lines[0].at(static_cast<double>(x)),
                                             at[1] - lines[1].at(static_cast<double>(y))));
    });
    const double least = std::min(lines[0].step, lines[1].step);
    if (least > 0.0 && worstM <= std::max(kMostCells * least, kMostAsideM)) return lines;
    throw Unplaced{
        fmt::format("XLAT and XLONG lie up to {:.4g} km off the map of the attributes "
                    "(MAP_PROJ {:g})",
                    1e-3 * worstM, file.number("MAP_PROJ").value_or(0.0))};
}

/// The grid around CEN_LAT and CEN_LON, for files without XLAT and XLONG.
std::array<Line, 2> aroundCentre(const Tiles& tiles, const std::array<double, 2>& stepsM,
                                 std::vector<std::string>& notes) {
    const NcFile& file = tiles.first();
    if (!tiles.partNote().empty()) {
        throw Unplaced{"the file is a part of its domain"};
    }
    const double latitude = requiredAngle(file, "CEN_LAT", 90.0);
    const double longitude = requiredAngle(file, "CEN_LON", 360.0);
    const auto centre = Map(projectionOf(file, longitude)).metres(latitude, longitude);
    std::array<Line, 2> lines;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        lines[axis].step = stepsM[axis];
        lines[axis].origin =
            centre[axis] - 0.5 * lines[axis].step * static_cast<double>(tiles.columns()[axis]);
    }
    notes.emplace_back(
        "XLAT or XLONG is missing: the place on the earth follows from CEN_LAT and CEN_LON.");
    return lines;
}

Place located(const Tiles& tiles, const std::array<double, 2>& spacingM,
              std::vector<std::string>& notes) {
    const NcFile& file = tiles.first();
    const Cells cells{flatField(tiles, "XLAT"), flatField(tiles, "XLONG"), tiles.columns()};
    const auto stepsM = nominalStepsM(file, spacingM);
    std::array<Line, 2> lines;
    Place place;
    if (cells.empty()) {
        try {
            place.projection = projectionOf(file, requiredAngle(file, "CEN_LON", 360.0));
            lines = aroundCentre(tiles, stepsM, notes);
        } catch (const Unplaced& unplaced) {
            throw Unplaced{"XLAT or XLONG is missing, and " + unplaced.reason};
        }
    } else {
        if (cells.areOne()) throw Unplaced{"XLAT or XLONG has one value in all cells"};
        const auto middle = static_cast<double>(cells.longitudeDeg[cells.middle()]);
        place.projection = projectionOf(file, std::isfinite(middle) ? middle : 0.0);
        lines = fitted(Map(place.projection), cells, file, stepsM);
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        place.mapOriginM[axis] = lines[axis].origin;
        place.mapPerGrid[axis] = lines[axis].step / spacingM[axis];
    }
    return place;
}

}  // namespace

std::vector<std::array<double, 2>> offsetsOf(const Tiles& tiles, const Place& place,
                                             const std::array<double, 2>& spacingM,
                                             const std::vector<std::size_t>& records) {
    std::vector<std::array<double, 2>> offsetsM(records.size());
    const auto* latitude = tiles.first().variable("XLAT");
    const auto* longitude = tiles.first().variable("XLONG");
    if (latitude == nullptr || longitude == nullptr) return offsetsM;
    const auto shape = tiles.shapeOf(*latitude);
    if (!shape || !shape->timed || !shape->flat) return offsetsM;
    const Map map(place.projection);
    const auto cornerAt = [&](std::size_t record) {
        const Box cell{{0, 0, 0}, {1, 1, 1}};
        float north = 0.0f, east = 0.0f;
        tiles.read(*latitude, record, cell, {&north, 1});
        tiles.read(*longitude, record, cell, {&east, 1});
        return map.metres(static_cast<double>(north), static_cast<double>(east));
    };
    const auto first = cornerAt(0);
    for (std::size_t i = 0; i < records.size(); ++i) {
        const auto corner = cornerAt(records[i]);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            constexpr double kWhole = 0.1;  // single precision misses by some metres
            const double stepM = place.mapPerGrid[axis] * spacingM[axis];
            const double cells = (corner[axis] - first[axis]) / stepM;
            if (!std::isfinite(cells)) return std::vector<std::array<double, 2>>(records.size());
            const double whole = std::round(cells);
            offsetsM[i][axis] = spacingM[axis] * (std::abs(cells - whole) < kWhole ? whole : cells);
        }
    }
    return offsetsM;
}

bool isIdealised(const NcFile& file) {
    return file.number("MAP_PROJ") == 0.0;
}

std::optional<Place> placeOf(const Tiles& tiles, const std::array<double, 2>& spacingM,
                             std::vector<std::string>& notes) {
    if (isIdealised(tiles.first())) return {};
    try {
        return located(tiles, spacingM, notes);
    } catch (const Unplaced& unplaced) {
        notes.push_back(fmt::format("The place on the earth is not known: {}.", unplaced.reason));
        return {};
    }
}

}  // namespace wrf
