// map_place.cpp: calls of PROJ. Only plain projections are let in: they need neither files nor the
// database.
#include "core/geo/map_place.h"

#include <fmt/format.h>
#include <proj.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/base/error.h"

namespace neph {
namespace {

constexpr std::size_t kLongest = 1000;  // of a PROJ string

Error unusable(const std::string& projection, const std::string& reason) {
    return Error({.where = {},
                  .what = "the projection cannot be used: " + reason,
                  .found = projection.substr(0, kLongest),
                  .expected = "a PROJ string of one projection to metres, such as +proj=lcc "
                              "+lat_1=30 +lat_2=60 +lon_0=-98 +R=6370000"});
}

/// Throws Error unless a text is a list of +key=value of a projection that is a formula.
void requirePlain(const std::string& projection) {
    if (projection.size() > kLongest) throw unusable(projection, "it is too long");
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) != 0 ||
               std::string_view("+=_.,- ").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!projection.starts_with("+proj=") || !std::ranges::all_of(projection, plain)) {
        throw unusable(projection, "it is no list of +key=value that begins with +proj");
    }
    constexpr std::array<std::string_view, 7> kForbidden{
        "init=", "grids=", "pipeline", "step", "catalog", "to_meter=", "unitconvert"};
    for (const std::string_view word : kForbidden) {
        if (projection.find(word) == std::string::npos) continue;
        throw unusable(projection, fmt::format("{} is not taken", word));
    }
    const std::size_t units = projection.find("+units=");
    if (units != std::string::npos && (projection + " ").substr(units, 9) != "+units=m ") {
        throw unusable(projection, "its units are not metres");
    }
}

}  // namespace

struct MapPlace::Projection {
    explicit Projection(const std::string& text) : context(proj_context_create()) {
        proj_log_func(context, nullptr, [](void*, int, const char*) {});  // errors are thrown
        proj_context_set_enable_network(context, 0);
        map = proj_create(context, text.c_str());
    }
    ~Projection() {
        proj_destroy(map);
        proj_context_destroy(context);
    }
    Projection(const Projection&) = delete;
    Projection& operator=(const Projection&) = delete;

    /// On the map to longitude and latitude in radians; nothing beyond its edge.
    std::optional<PJ_COORD> inverse(glm::dvec2 mapM) const {
        const PJ_COORD geo = proj_trans(map, PJ_INV, proj_coord(mapM.x, mapM.y, 0.0, 0.0));
        // Some projections answer for places that they do not show.
        if (!std::isfinite(geo.lp.lam) || !(std::abs(geo.lp.phi) <= 1.5707964)) return {};
        return geo;
    }

    PJ_CONTEXT* context;
    PJ* map;
};

MapPlace::MapPlace(const MapGrid& grid) : grid_(grid) {
    requirePlain(grid.projection);
    projection_ = std::make_unique<Projection>(grid.projection);
    const PJ* map = projection_->map;
    if (map == nullptr) {
        const int code = proj_context_errno(projection_->context);
        const char* reason = proj_context_errno_string(projection_->context, code);
        throw unusable(grid.projection, reason != nullptr ? reason : "PROJ does not know it");
    }
    if (proj_angular_output(projection_->map, PJ_FWD) != 0 ||
        proj_degree_output(projection_->map, PJ_FWD) != 0 ||
        proj_pj_info(projection_->map).has_inverse == 0) {
        throw unusable(grid.projection, "it does not lead from the earth to metres and back");
    }
    const glm::dvec2 scale = grid.mapPerGrid;
    if (!(scale.x > 0.0) || !(scale.y > 0.0) || !std::isfinite(scale.x + scale.y) ||
        !std::isfinite(grid.originM.x + grid.originM.y)) {
        throw unusable(
            grid.projection,
            fmt::format("the grid begins at {}, {} m with {} x {} m of the map per metre",
                        grid.originM.x, grid.originM.y, scale.x, scale.y));
    }
}

MapPlace::~MapPlace() = default;
MapPlace::MapPlace(MapPlace&&) noexcept = default;
MapPlace& MapPlace::operator=(MapPlace&&) noexcept = default;

std::optional<GeoPoint> MapPlace::geoAt(glm::dvec2 atM) const {
    const auto geo = projection_->inverse(grid_.originM + atM * grid_.mapPerGrid);
    if (!geo) return {};
    return GeoPoint{proj_todeg(geo->lp.phi), std::remainder(proj_todeg(geo->lp.lam), 360.0)};
}

std::optional<PlacePoint> MapPlace::at(glm::dvec2 atM) const {
    constexpr double kHalfStepM = 50.0;       // on the map
    constexpr double kNextToPoleDeg = 0.001;  // 110 m: the steps would pass it
    const glm::dvec2 mapM = grid_.originM + atM * grid_.mapPerGrid;
    const auto geo = geoAt(atM);
    if (!geo) return {};
    if (std::abs(geo->latitudeDeg) > 90.0 - kNextToPoleDeg) {
        return at(atM + glm::dvec2(8.0 * kHalfStepM / grid_.mapPerGrid.x, 0.0));
    }
    PlacePoint point{.geo = *geo};
    const PJ_COORD middle =
        proj_coord(proj_torad(geo->longitudeDeg), proj_torad(geo->latitudeDeg), 0.0, 0.0);
    glm::dvec2 gridNorth(0.0);  // east and north of the grid's y axis
    for (const int axis : {0, 1}) {
        double lengthM = 0.0;
        for (const double side : {-1.0, 1.0}) {
            glm::dvec2 besideM = mapM;
            besideM[axis] += side * kHalfStepM;
            const auto beside = projection_->inverse(besideM);
            if (!beside) return {};
            const PJ_COORD line = proj_geod(projection_->map, middle, *beside);
            lengthM += line.xyz.x;
            if (axis == 0) continue;
            const double azimuthRad = proj_torad(line.xyz.y);
            gridNorth += side * glm::dvec2(std::sin(azimuthRad), std::cos(azimuthRad));
        }
        if (!(lengthM > 0.0)) return {};
        point.mapFactor[axis] = 2.0 * kHalfStepM / lengthM;
    }
    point.convergenceDeg = -proj_todeg(std::atan2(gridNorth.x, gridNorth.y));
    return point;
}

std::optional<glm::dvec2> MapPlace::positionM(GeoPoint geo) const {
    const PJ_COORD from =
        proj_coord(proj_torad(geo.longitudeDeg), proj_torad(geo.latitudeDeg), 0.0, 0.0);
    const PJ_COORD mapM = proj_trans(projection_->map, PJ_FWD, from);
    if (!std::isfinite(mapM.xy.x) || !std::isfinite(mapM.xy.y)) return {};
    return (glm::dvec2(mapM.xy.x, mapM.xy.y) - grid_.originM) / grid_.mapPerGrid;
}

}  // namespace neph
