// grid.cpp: grid definition templates 3.0, 3.1, 3.10, 3.20 and 3.30, and their maps by PROJ.
#include "readers/grib/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "readers/grib/proj_map.h"

namespace grib {
namespace {

constexpr double kMicro = 1e-6, kMilli = 1e-3;
constexpr std::size_t kMostPoints = 1U << 20U;  // along one axis; no model comes near
constexpr double kLeastM = 1e-3, kMostM = 1e6;  // width of cells

enum Template : unsigned {
    kLatitudeLongitude = 0,
    kRotated = 1,
    kMercator = 10,
    kPolar = 20,
    kLambert = 30
};

const char* const kRegrid =
    "wgrib2 IN -new_grid latlon LON0:NX:DLON LAT0:NY:DLAT OUT, or cdo -f grb2 remapbil,GRID IN OUT";

/// The earth as PROJ takes it, and its radius at the equator in metres.
struct Earth {
    std::string text;
    double radiusM = 0.0;
};

Earth sphere(double radiusM) {
    return {fmt::format("+R={:.10g}", radiusM), radiusM};
}

Earth ellipsoid(double a, double b) {
    return {fmt::format("+a={:.10g} +b={:.10g}", a, b), a};
}

/// Code table 3.2.
Earth earthOf(ByteSpan s) {
    const auto stated = [&](std::size_t at) {
        return static_cast<double>(unsignedAt(s, at + 1, 4)) *
               std::pow(10.0, static_cast<double>(-signedAt(s, at, 1)));
    };
    switch (unsignedAt(s, 14, 1)) {
        case 0:
            return sphere(6367470.0);
        case 1:
            return sphere(stated(15));
        case 2:
            return ellipsoid(6378160.0, 6356775.0);  // IAU 1965
        case 3:
            return ellipsoid(1e3 * stated(20), 1e3 * stated(25));
        case 4:
            return {"+ellps=GRS80", 6378137.0};
        case 5:
            return {"+ellps=WGS84", 6378137.0};
        case 6:
            return sphere(6371229.0);
        case 7:
            return ellipsoid(stated(20), stated(25));
        case 8:
            return sphere(6371200.0);
        case 9:
            return {"+ellps=airy", 6377563.396};
        default:
            throw Failure{"the shape of the earth is not known here",
                          fmt::format("shape {} of code table 3.2", unsignedAt(s, 14, 1)),
                          "shape 0 to 9", kRegrid};
    }
}

/// What the templates state, in degrees and metres.
struct Stated {
    unsigned form = 0;
    double firstLatitude = 0.0, firstLongitude = 0.0;
    double lastLatitude = 0.0, lastLongitude = 0.0;  ///< of grids in degrees
    std::array<double, 2> step{};                    ///< degrees or metres on the map
    unsigned scanning = 0;
    std::string map;  ///< the projection without the earth
};

double degreesAt(ByteSpan s, std::size_t at) {
    return kMicro * static_cast<double>(signedAt(s, at, 4));
}

double metresAt(ByteSpan s, std::size_t at) {
    return kMilli * static_cast<double>(unsignedAt(s, at, 4));
}

/// Longitude in [-180, 180).
double wrapped(double degrees) {
    return degrees - 360.0 * std::floor((degrees + 180.0) / 360.0);
}

Stated lambertOf(ByteSpan s) {
    Stated g;
    g.step = {metresAt(s, 55), metresAt(s, 59)};
    g.scanning = static_cast<unsigned>(unsignedAt(s, 64, 1));
    g.map = fmt::format("+proj=lcc +lat_1={:.9g} +lat_2={:.9g} +lat_0={:.9g} +lon_0={:.9g}",
                        degreesAt(s, 65), degreesAt(s, 69), degreesAt(s, 47),
                        wrapped(degreesAt(s, 51)));
    return g;
}

Stated polarOf(ByteSpan s) {
    Stated g;
    const bool south = (unsignedAt(s, 63, 1) & 0x80U) != 0;
    const double trueLatitude = std::abs(degreesAt(s, 47));
    g.step = {metresAt(s, 55), metresAt(s, 59)};
    g.scanning = static_cast<unsigned>(unsignedAt(s, 64, 1));
    g.map = fmt::format("+proj=stere +lat_0={} +lat_ts={:.9g} +lon_0={:.9g}", south ? -90 : 90,
                        south ? -trueLatitude : trueLatitude, wrapped(degreesAt(s, 51)));
    return g;
}

Stated mercatorOf(ByteSpan s) {
    Stated g;
    if (unsignedAt(s, 60, 4) != 0) {
        throw Failure{"its Mercator grid is turned against the equator",
                      fmt::format("orientation {:g} degrees", degreesAt(s, 60)), "0", kRegrid};
    }
    g.step = {metresAt(s, 64), metresAt(s, 68)};
    g.scanning = static_cast<unsigned>(unsignedAt(s, 59, 1));
    const double first = degreesAt(s, 42);
    const double east = std::fmod(std::fmod(degreesAt(s, 55) - first, 360.0) + 360.0, 360.0);
    g.map = fmt::format("+proj=merc +lat_ts={:.9g} +lon_0={:.9g}", degreesAt(s, 47),
                        wrapped(first + 0.5 * east));
    return g;
}

/// Grids in degrees, of the earth or with a pole that is moved.
Stated degreesOf(ByteSpan s, unsigned form, std::size_t columns, std::size_t rows) {
    Stated g;
    // Regulation 92.1.6: angles are in units of a basic angle where that is not 0.
    const auto basic = unsignedAt(s, 38, 4), parts = unsignedAt(s, 42, 4);
    if (basic != 0 && basic != 0xffffffffU && !(basic == 1 && parts == 1'000'000)) {
        throw Failure{"its grid has angles in a unit of its own",
                      fmt::format("basic angle {} / {}", basic, parts), "millionths of a degree",
                      kRegrid};
    }
    g.lastLatitude = degreesAt(s, 55);
    g.lastLongitude = degreesAt(s, 59);
    g.scanning = static_cast<unsigned>(unsignedAt(s, 71, 1));
    const double firstLatitude = degreesAt(s, 46), firstLongitude = degreesAt(s, 50);
    // The first and the last point are exact where increments are rounded.
    const bool westward = (g.scanning & 0x80U) != 0;
    double across = westward ? firstLongitude - g.lastLongitude : g.lastLongitude - firstLongitude;
    across -= 360.0 * std::floor(across / 360.0);
    g.step = {columns > 1 ? across / static_cast<double>(columns - 1) : degreesAt(s, 63),
              rows > 1 ? std::abs(g.lastLatitude - firstLatitude) / static_cast<double>(rows - 1)
                       : degreesAt(s, 67)};
    if (form == kLatitudeLongitude) {
        const double east = westward ? g.lastLongitude : firstLongitude;
        g.map = fmt::format("+proj=eqc +lon_0={:.9g}", wrapped(east + 0.5 * across));
    } else {
        g.map =
            fmt::format("+proj=ob_tran +o_proj=eqc +o_lat_p={:.9g} +o_lon_p={:.9g} +lon_0={:.9g}",
                        -degreesAt(s, 72), -realAt(s, 80), wrapped(degreesAt(s, 76)));
    }
    return g;
}

/// Mean width of cells on the earth as a share of that on the map (the mean of areas), and how far
/// cells differ from it.
struct MeanWidth {
    double share = 1.0, deviation = 0.0;
};

MeanWidth widthOf(const ProjectedMap& map, const Grid& grid, const std::array<double, 2>& step) {
    constexpr std::size_t kMostSamples = 48;  // along an axis
    std::array<std::size_t, 2> count{};
    for (std::size_t axis = 0; axis < 2; ++axis)
        count[axis] = std::min(grid.size[axis], kMostSamples);
    double sum = 0.0, least = 1e300, greatest = 0.0, samples = 0.0;
    for (std::size_t i = 0; i < count[0] * count[1]; ++i) {
        const auto at = [&](std::size_t axis, std::size_t n) {
            return grid.mapOriginM[axis] + step[axis] * static_cast<double>(grid.size[axis]) *
                                               (static_cast<double>(n) + 0.5) /
                                               static_cast<double>(count[axis]);
        };
        const auto factor = map.factor({at(0, i % count[0]), at(1, i / count[0])});
        if (!factor) continue;
        const double width = 1.0 / *factor;
        sum += width * width;
        least = std::min(least, width);
        greatest = std::max(greatest, width);
        samples += 1.0;
    }
    if (samples == 0.0) return {};
    const double mean = std::sqrt(sum / samples);
    return {mean, std::max(greatest / mean - 1.0, 1.0 - least / mean)};
}

void requireEven(ByteSpan s) {
    const auto form = unsignedAt(s, 12, 2);
    if (unsignedAt(s, 5, 1) != 0) {
        throw Failure{
            "its grid is one of a centre's own list", {}, "a grid that states its points", kRegrid};
    }
    if (form != kLatitudeLongitude && form != kRotated && form != kMercator && form != kPolar &&
        form != kLambert) {
        const char* kind = form == 40                   ? " (Gaussian)"
                           : form == 50                 ? " (spherical harmonics)"
                           : form == 90                 ? " (view from space)"
                           : form == 100 || form == 101 ? " (unstructured, as of ICON)"
                                                        : "";
        throw Failure{"its grid is none that can be read",
                      fmt::format("grid definition template 3.{}{}", form, kind),
                      "a latitude-longitude, rotated latitude-longitude, Mercator, polar "
                      "stereographic or Lambert conformal grid",
                      kRegrid};
    }
    if (unsignedAt(s, 10, 1) != 0) {
        throw Failure{"its grid has rows of different lengths (a reduced grid)",
                      {},
                      "rows of one length",
                      kRegrid};
    }
}

/// Latitude-longitude grids: degrees become metres at the equator, and cells are narrower by the
/// cosine of their latitude, in the mean over the rows.
void placeDegrees(Grid& grid, const Stated& g, double radiusM) {
    const double perDegree = radiusM * std::numbers::pi / 180.0;
    double sum = 0.0;
    const double south = std::min(g.firstLatitude, g.lastLatitude);
    for (std::size_t row = 0; row < grid.size[1]; ++row) {
        sum += std::cos((south + g.step[1] * static_cast<double>(row)) * std::numbers::pi / 180.0);
    }
    const double share = sum / static_cast<double>(grid.size[1]);
    grid.spacingM = {perDegree * g.step[0] * share, perDegree * g.step[1]};
    grid.mapPerGrid = {1.0 / share, 1.0};
    grid.note = fmt::format(
        "Cells of {:.6g} x {:.6g} degrees are taken as {:.0f} x {:.0f} m, "
        "the mean width over the rows.",
        g.step[0], g.step[1], grid.spacingM[0], grid.spacingM[1]);
}

void requireWidths(const Grid& grid) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (grid.spacingM[axis] >= kLeastM && grid.spacingM[axis] <= kMostM) continue;
        throw Failure{fmt::format("its grid has an impossible spacing in {}", "xy"[axis]),
                      fmt::format("{:g} m", grid.spacingM[axis]),
                      fmt::format("{:g} to {:g} m", kLeastM, kMostM),
                      "the message is damaged: download the file again"};
    }
}

/// The south-west corner on the map, from the first point.
void placeOrigin(Grid& grid, const std::array<double, 2>& first,
                 const std::array<double, 2>& step) {
    const std::array<bool, 2> falling{grid.order.westward, !grid.order.northward};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double back = falling[axis] ? static_cast<double>(grid.size[axis] - 1) : 0.0;
        grid.mapOriginM[axis] = first[axis] - (back + 0.5) * step[axis];
    }
}

const char* kindName(unsigned form) {
    switch (form) {
        case kLatitudeLongitude:
            return "latitude-longitude";
        case kRotated:
            return "rotated latitude-longitude";
        case kMercator:
            return "Mercator";
        case kPolar:
            return "polar stereographic";
        default:
            return "Lambert conformal";
    }
}

Stated statedBy(ByteSpan s, const Grid& grid) {
    const auto form = static_cast<unsigned>(unsignedAt(s, 12, 2));
    const bool inDegrees = form == kLatitudeLongitude || form == kRotated;
    Stated g = inDegrees           ? degreesOf(s, form, grid.size[0], grid.size[1])
               : form == kMercator ? mercatorOf(s)
               : form == kPolar    ? polarOf(s)
                                   : lambertOf(s);
    g.form = form;
    g.firstLatitude = degreesAt(s, inDegrees ? 46 : 38);
    g.firstLongitude = degreesAt(s, inDegrees ? 50 : 42);
    return g;
}

ScanOrder orderOf(unsigned scanning) {
    if ((scanning & 0x0fU) != 0) {
        throw Failure{"rows of its grid are set off against each other",
                      fmt::format("scanning mode {}", scanning), "a scanning mode without offsets",
                      kRegrid};
    }
    return {(scanning & 0x80U) != 0, (scanning & 0x40U) != 0, (scanning & 0x20U) != 0,
            (scanning & 0x10U) != 0};
}

}  // namespace

Grid gridOf(ByteSpan s) {
    requireEven(s);
    Grid grid;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::uint64_t points = unsignedAt(s, 30 + 4 * axis, 4);
        if (points == 0 || points > kMostPoints) {
            throw Failure{fmt::format("its grid has {} in {}",
                                      points == 0 ? "no points" : "an impossible size",
                                      axis == 0 ? "x" : "y"),
                          fmt::format("{} points", points), fmt::format("1 to {}", kMostPoints),
                          kRegrid};
        }
        grid.size[axis] = static_cast<std::size_t>(points);
    }
    if (unsignedAt(s, 6, 4) != grid.size[0] * grid.size[1]) {
        throw Failure{
            "its grid contradicts itself",
            fmt::format("{} points, {} x {}", unsignedAt(s, 6, 4), grid.size[0], grid.size[1]),
            "as many points as rows times columns",
            "the message is damaged: download the file again"};
    }
    const Stated g = statedBy(s, grid);
    grid.order = orderOf(g.scanning);
    const bool inDegrees = g.form == kLatitudeLongitude || g.form == kRotated;
    grid.windsAlongGrid = (unsignedAt(s, inDegrees ? 54 : 46, 1) & 0x08U) != 0;
    grid.name = fmt::format("{}, {} x {} points, first {:.3f} N {:.3f} E", kindName(g.form),
                            grid.size[0], grid.size[1], g.firstLatitude, g.firstLongitude);
    const Earth earth = earthOf(s);
    if (inDegrees) {
        grid.projection = g.map + fmt::format(" +R={:.10g} +units=m", earth.radiusM);
        placeDegrees(grid, g, earth.radiusM);
        requireWidths(grid);
        const double perDegree = earth.radiusM * std::numbers::pi / 180.0;
        const std::array<double, 2> step{perDegree * g.step[0], perDegree * g.step[1]};
        const std::array<double, 2> first =
            g.form == kRotated
                ? std::array<double, 2>{perDegree * wrapped(g.firstLongitude),
                                        perDegree * g.firstLatitude}
                : ProjectedMap(grid.projection).metres(g.firstLatitude, g.firstLongitude);
        placeOrigin(grid, first, step);
        return grid;
    }
    grid.projection = g.map + " " + earth.text + " +units=m";
    const ProjectedMap map(grid.projection);
    placeOrigin(grid, map.metres(g.firstLatitude, g.firstLongitude), g.step);
    const MeanWidth width = widthOf(map, grid, g.step);
    for (std::size_t axis = 0; axis < 2; ++axis) grid.spacingM[axis] = g.step[axis] * width.share;
    requireWidths(grid);
    grid.mapPerGrid = {1.0 / width.share, 1.0 / width.share};
    grid.note = fmt::format(
        "Cells are taken as {:.6g} x {:.6g} m everywhere, their mean on the earth, from which they "
        "differ by up to {:.2g} %.",
        grid.spacingM[0], grid.spacingM[1], 1e2 * width.deviation);
    return grid;
}

}  // namespace grib
