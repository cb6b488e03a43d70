// proj_map.cpp: calls of PROJ.
#include "readers/grib/proj_map.h"

#include <fmt/format.h>
#include <proj.h>

#include <cmath>

#include "readers/grib/bytes.h"

namespace grib {

ProjectedMap::ProjectedMap(const std::string& projection) : context_(proj_context_create()) {
    proj_log_func(context_, nullptr, [](void*, int, const char*) {});
    map_ = proj_create(context_, projection.c_str());
    if (map_ != nullptr) return;
    proj_context_destroy(context_);
    throw Failure{"its grid makes no map projection", projection, "a projection that PROJ knows",
                  "the message is damaged: download the file again"};
}

ProjectedMap::~ProjectedMap() {
    proj_destroy(map_);
    proj_context_destroy(context_);
}

std::array<double, 2> ProjectedMap::metres(double latitude, double longitude) const {
    const PJ_COORD geo = proj_coord(proj_torad(longitude), proj_torad(latitude), 0, 0);
    const PJ_COORD at = proj_trans(map_, PJ_FWD, geo);
    if (std::isfinite(at.xy.x) && std::isfinite(at.xy.y)) return {at.xy.x, at.xy.y};
    throw Failure{"the first point of its grid is not on its map",
                  fmt::format("{:g} N {:g} E", latitude, longitude),
                  "a point that the projection shows",
                  "the message is damaged: download the file again"};
}

std::optional<double> ProjectedMap::factor(const std::array<double, 2>& metres) const {
    const PJ_COORD geo = proj_trans(map_, PJ_INV, proj_coord(metres[0], metres[1], 0, 0));
    if (!std::isfinite(geo.lp.lam) || !std::isfinite(geo.lp.phi)) return {};
    const PJ_FACTORS factors = proj_factors(map_, geo);
    if (!(factors.areal_scale > 0.0) || !std::isfinite(factors.areal_scale)) return {};
    return std::sqrt(factors.areal_scale);
}

}  // namespace grib
