// wrf_place_test.cpp: where WRF's domains lie, against WRF's own equations of its maps and, if
// NEPHOSCOPE_MAPPED_RUN names a file of a real run on a map, against what WRF wrote into it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/geo/map_place.h"
#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

const char* const kMappedRun = std::getenv("NEPHOSCOPE_MAPPED_RUN");

double rad(double degrees) {
    return glm::radians(degrees);
}

/// The map of a domain as WRF has it in share/module_llxy.F, here in doubles: ijll_lc, ijll_ps,
/// ijll_merc, ijll_cassini and rotate_coords. Cells are counted from 0.
struct WrfMap {
    int projection = 1;
    double trueLatitude1 = 0.0, trueLatitude2 = 0.0, standLongitude = 0.0;
    double poleLatitude = 90.0, poleLongitude = 0.0;
    double stepM = 10000.0;
    /// Cell at the pole, or on the equator and the standard longitude.
    double poleX = 0.0, poleY = 0.0;

    static constexpr double kRadiusM = 6370000.0;

    double hemisphere() const { return trueLatitude1 < 0.0 ? -1.0 : 1.0; }
    double cone() const {
        if (projection == 2) return 1.0;
        if (std::abs(trueLatitude1 - trueLatitude2) <= 0.1) {
            return std::sin(rad(std::abs(trueLatitude1)));
        }
        return std::log(std::cos(rad(trueLatitude1)) / std::cos(rad(trueLatitude2))) /
               std::log(std::tan(rad(45.0 - 0.5 * std::abs(trueLatitude1))) /
                        std::tan(rad(45.0 - 0.5 * std::abs(trueLatitude2))));
    }
    GeoPoint conical(double x, double y) const {
        const double chi1 = rad(90.0 - std::abs(trueLatitude1));
        const double east = (x - poleX) * stepM / kRadiusM;
        const double south = hemisphere() * (poleY - y) * stepM / kRadiusM;
        const double r = std::hypot(east, south);
        const double n = cone();
        const double chi =
            projection == 2
                ? 2.0 * std::atan(r / (1.0 + std::sin(rad(std::abs(trueLatitude1)))))
                : 2.0 * std::atan(std::tan(0.5 * chi1) * std::pow(r * n / std::sin(chi1), 1.0 / n));
        return {hemisphere() * (90.0 - glm::degrees(chi)),
                standLongitude + glm::degrees(std::atan2(east, south)) / n};
    }
    GeoPoint mercator(double x, double y) const {
        const double step = stepM / (kRadiusM * std::cos(rad(trueLatitude1)));
        return {glm::degrees(2.0 * std::atan(std::exp(step * (y - poleY)))) - 90.0,
                standLongitude + glm::degrees(step * (x - poleX))};
    }
    GeoPoint rotated(double x, double y) const {
        const double step = stepM / kRadiusM;
        const double lat = step * (y - poleY), lon = step * (x - poleX);
        if (std::abs(poleLatitude) == 90.0) return {glm::degrees(lat), glm::degrees(lon)};
        const double np = rad(poleLatitude), turn = lon - rad(poleLongitude);
        const double sinphi =
            std::cos(np) * std::cos(lat) * std::cos(turn) + std::sin(np) * std::sin(lat);
        const double coslam =
            std::sin(np) * std::cos(lat) * std::cos(turn) - std::cos(np) * std::sin(lat);
        const double sinlam = std::cos(lat) * std::sin(turn);
        return {glm::degrees(std::asin(sinphi)),
                glm::degrees(std::atan2(sinlam, coslam)) - standLongitude};
    }
    GeoPoint at(double x, double y) const {
        GeoPoint geo = projection <= 2   ? conical(x, y)
                       : projection == 3 ? mercator(x, y)
                                         : rotated(x, y);
        geo.longitudeDeg = std::remainder(geo.longitudeDeg, 360.0);
        return geo;
    }
};

struct Domain {
    const char* name;
    WrfMap map;
};

const Domain kDomains[]{
    {"Lambert, northern plains",
     {.projection = 1,
      .trueLatitude1 = 30.0,
      .trueLatitude2 = 60.0,
      .standLongitude = -98.0,
      .stepM = 3000.0,
      .poleX = -120.0,
      .poleY = 2300.0}},
    {"Lambert, one true latitude, Australia",
     {.projection = 1,
      .trueLatitude1 = -25.0,
      .trueLatitude2 = -25.0,
      .standLongitude = 130.0,
      .stepM = 12000.0,
      .poleX = 5.0,
      .poleY = -1100.0}},
    {"Lambert across the date line",
     {.projection = 1,
      .trueLatitude1 = 50.0,
      .trueLatitude2 = 60.0,
      .standLongitude = 179.0,
      .stepM = 10000.0,
      .poleX = 20.0,
      .poleY = 420.0}},
    {"Polar, over Greenland",
     {.projection = 2,
      .trueLatitude1 = 64.0,
      .standLongitude = -45.0,
      .stepM = 5000.0,
      .poleX = 12.0,
      .poleY = 300.0}},
    {"Polar, with the south pole in it",
     {.projection = 2,
      .trueLatitude1 = -71.0,
      .standLongitude = 0.0,
      .stepM = 15000.0,
      .poleX = 10.2,
      .poleY = 9.7}},
    {"Mercator, true at 20 N",
     {.projection = 3,
      .trueLatitude1 = 20.0,
      .standLongitude = -60.0,
      .stepM = 9000.0,
      .poleX = -20.0,
      .poleY = -200.0}},
    {"Mercator across the date line",
     {.projection = 3,
      .trueLatitude1 = 0.0,
      .standLongitude = 177.0,
      .stepM = 30000.0,
      .poleX = 0.0,
      .poleY = 30.0}},
    {"latitude and longitude",
     {.projection = 6, .standLongitude = 0.0, .stepM = 20000.0, .poleX = -600.0, .poleY = 100.0}},
    {"rotated pole, central Europe",
     {.projection = 6,
      .standLongitude = -10.0,
      .poleLatitude = 40.0,
      .poleLongitude = 180.0,
      .stepM = 7000.0,
      .poleX = 11.0,
      .poleY = 8.0}},
    {"rotated pole elsewhere",
     {.projection = 6,
      .standLongitude = 97.0,
      .poleLatitude = 52.5,
      .poleLongitude = 170.0,
      .stepM = 7000.0,
      .poleX = -30.0,
      .poleY = 60.0}},
};

/// A file on a map, with XLAT and XLONG in single precision as WRF writes them.
WrfSpec specOf(const WrfMap& map) {
    WrfSpec spec;
    spec.nx = 24;
    spec.ny = 20;
    spec.nz = 2;
    spec.dx = spec.dy = static_cast<float>(map.stepM);
    spec.mapProjection = map.projection;
    spec.times = {"2021-08-14_18:00:00"};
    spec.attributes = {{"TRUELAT1", map.trueLatitude1},
                       {"TRUELAT2", map.trueLatitude2},
                       {"STAND_LON", map.standLongitude},
                       {"POLE_LAT", map.poleLatitude},
                       {"POLE_LON", map.poleLongitude},
                       {"CEN_LAT", map.at(11.5, 9.5).latitudeDeg},
                       {"CEN_LON", map.at(11.5, 9.5).longitudeDeg}};
    spec.flat["XLAT"] = [map](int x, int y, int, int) {
        return static_cast<float>(map.at(x, y).latitudeDeg);
    };
    spec.flat["XLONG"] = [map](int x, int y, int, int) {
        return static_cast<float>(map.at(x, y).longitudeDeg);
    };
    return spec;
}

/// Metres between two places.
double distanceM(GeoPoint a, GeoPoint b) {
    const auto unit = [](GeoPoint p) {
        return glm::dvec3(std::cos(rad(p.latitudeDeg)) * std::cos(rad(p.longitudeDeg)),
                          std::cos(rad(p.latitudeDeg)) * std::sin(rad(p.longitudeDeg)),
                          std::sin(rad(p.latitudeDeg)));
    };
    return WrfMap::kRadiusM * glm::length(unit(a) - unit(b));
}

/// The largest distance in metres between the cells of a data set and those of a map.
double worstM(const DatasetInfo& info, const WrfMap& map) {
    const MapPlace place(info.map);
    double worst = 0.0;
    for (int y = 0; y < info.size.y; ++y) {
        for (int x = 0; x < info.size.x; ++x) {
            const auto geo = place.geoAt((glm::dvec2(x, y) + 0.5) * info.spacingM);
            REQUIRE(geo);
            worst = std::max(worst, distanceM(*geo, map.at(x, y)));
        }
    }
    return worst;
}

DatasetInfo infoOf(const TemporaryFolder& folder, const WrfSpec& spec) {
    writeWrf(folder / "wrfout", spec);
    return openFiles({folder / "wrfout"})->info();
}

}  // namespace

TEST_CASE("Cells of all of WRF's maps lie where its own equations have them") {
    for (const Domain& domain : kDomains) {
        CAPTURE(domain.name);
        const TemporaryFolder folder;
        const DatasetInfo info = infoOf(folder, specOf(domain.map));
        REQUIRE(!info.map.projection.empty());
        CHECK(worstM(info, domain.map) < 1.0);  // single precision rounds degrees to a metre
        CHECK_FALSE(hasNote(info, "place"));
    }
}

TEST_CASE("True north and map factors are those that WRF writes") {
    const WrfMap map = kDomains[0].map;
    const TemporaryFolder folder;
    WrfSpec spec = specOf(map);
    // get_map_factor and get_rotang of WPS for Lambert's map.
    const auto factor = [&](int x, int y) {
        const double chi1 = rad(90.0 - map.trueLatitude1);
        const double chi = rad(90.0 - map.at(x, y).latitudeDeg);
        return std::sin(chi1) / std::sin(chi) *
               std::pow(std::tan(0.5 * chi) / std::tan(0.5 * chi1), map.cone());
    };
    spec.flat["MAPFAC_M"] = [&](int x, int y, int, int) {
        return static_cast<float>(factor(x, y));
    };
    const DatasetInfo info = infoOf(folder, spec);
    CHECK(info.map.mapPerGrid.x == doctest::Approx(3000.0 / info.spacingM.x));
    CHECK(worstM(info, map) < 1.0);
    const MapPlace place(info.map);
    for (const glm::ivec2 cell : {glm::ivec2(0, 0), glm::ivec2(23, 0), glm::ivec2(12, 19)}) {
        const auto point = place.at((glm::dvec2(cell) + 0.5) * info.spacingM);
        REQUIRE(point);
        const double alphaDeg =
            (map.standLongitude - map.at(cell.x, cell.y).longitudeDeg) * map.cone();
        CHECK(point->convergenceDeg == doctest::Approx(alphaDeg).epsilon(1e-4));
        CHECK(point->mapFactor.x == doctest::Approx(factor(cell.x, cell.y)).epsilon(1e-5));
        CHECK(point->mapFactor.y == doctest::Approx(factor(cell.x, cell.y)).epsilon(1e-5));
    }
}

TEST_CASE("Rows that are stored from north to south, and columns left out, keep their places") {
    const WrfMap map = kDomains[0].map;
    const TemporaryFolder folder;
    WrfSpec turned = specOf(map);
    for (const char* name : {"XLAT", "XLONG"}) {
        turned.flat[name] = [upright = turned.flat[name]](int x, int y, int z, int t) {
            return upright(x, 19 - y, z, t);
        };
    }
    CHECK(worstM(infoOf(folder, turned), map) < 1.0);
    WrfSpec thinned = specOf(map);
    for (const char* name : {"XLAT", "XLONG"}) {
        thinned.flat[name] = [whole = thinned.flat[name]](int x, int y, int z, int t) {
            return whole(3 * x, 3 * y, z, t);
        };
    }
    const DatasetInfo info = infoOf(folder, thinned);
    CHECK(info.spacingM.x == doctest::Approx(9000.0));
    WrfMap coarse = map;
    coarse.stepM *= 3.0;
    coarse.poleX /= 3.0;
    coarse.poleY /= 3.0;
    CHECK(worstM(info, coarse) < 1.0);
}

TEST_CASE("Without XLAT and XLONG the place follows from the centre, with a note") {
    for (const Domain& domain : kDomains) {
        CAPTURE(domain.name);
        const TemporaryFolder folder;
        WrfSpec spec = specOf(domain.map);
        spec.flat.clear();
        const DatasetInfo info = infoOf(folder, spec);
        CHECK(hasNote(info, "follows from CEN_LAT and CEN_LON"));
        CHECK(worstM(info, domain.map) < 1.0);
    }
}

TEST_CASE("An idealised run has neither place nor date and says so") {
    const TemporaryFolder folder;
    WrfSpec spec;
    const DatasetInfo info = infoOf(folder, spec);
    CHECK(info.map.projection.empty());
    CHECK_FALSE(info.times.at(0).utc);
    CHECK(info.noPlace == "the run is idealised (MAP_PROJ 0)");
    CHECK_FALSE(hasNote(info, "place"));
    spec.times = {"2021-08-14_18:00:00"};
    const DatasetInfo dated = infoOf(folder, spec);
    CHECK(!dated.noPlace.empty());
    CHECK(utcText(dated.times.at(0).utc.value()) == "2021-08-14T18:00:00Z");
}

TEST_CASE("Places that the attributes do not tell, or contradict, are unknown with the reason") {
    const WrfMap map = kDomains[0].map;
    const auto noteOf = [&](const auto& change) {
        const TemporaryFolder folder;
        WrfSpec spec = specOf(map);
        change(spec);
        const DatasetInfo info = infoOf(folder, spec);
        CHECK(info.map.projection.empty());
        for (const std::string& note : info.notes) {
            if (contains(note, "place on the earth is not known")) return note;
        }
        return std::string();
    };
    CHECK(contains(noteOf([](WrfSpec& s) { s.omit = {"MAP_PROJ"}; }), "MAP_PROJ is missing"));
    CHECK(contains(noteOf([](WrfSpec& s) { s.mapProjection = 203; }), "MAP_PROJ 203"));
    CHECK(contains(noteOf([](WrfSpec& s) { s.attributes.erase("STAND_LON"); }),
                   "STAND_LON is missing"));
    CHECK(contains(noteOf([](WrfSpec& s) { s.attributes["TRUELAT1"] = 120.5; }),
                   "TRUELAT1 is 120.5"));
    CHECK(contains(noteOf([](WrfSpec& s) { s.attributes["TRUELAT2"] = -30.0; }),
                   "make no map projection"));
    CHECK(contains(noteOf([](WrfSpec& s) { s.attributes["STAND_LON"] = -60.0; }),
                   "off the map of the attributes (MAP_PROJ 1)"));
    CHECK(contains(noteOf([](WrfSpec& s) { s.flat["XLAT"] = everywhere(45.0f); }), "one value"));
    CHECK(contains(noteOf([](WrfSpec& s) {
                       s.flat.clear();
                       s.attributes.erase("CEN_LAT");
                   }),
                   "CEN_LAT is missing"));
}

TEST_CASE("Times of WRF are in UTC, also across leap days, in one file and in a series") {
    const TemporaryFolder folder;
    WrfSpec spec = specOf(kDomains[0].map);
    spec.times = {"2020-02-28_12:00:00", "2020-02-29_12:00:00"};
    writeWrf(folder / "a", spec);
    spec.times = {"2020-03-01_00:30:00"};
    writeWrf(folder / "b", spec);
    const auto times = openFiles({folder / "a", folder / "b"})->info().times;
    REQUIRE(times.size() == 3);
    CHECK(utcText(times[0].utc.value()) == "2020-02-28T12:00:00Z");
    CHECK(utcText(times[1].utc.value()) == "2020-02-29T12:00:00Z");
    CHECK(utcText(times[2].utc.value()) == "2020-03-01T00:30:00Z");
}

TEST_CASE("Times in a calendar without leap days have no date in UTC") {
    const TemporaryFolder folder;
    WrfSpec spec = specOf(kDomains[0].map);
    spec.omit = {"Times"};
    spec.xtime = {60.0};
    CHECK(utcText(infoOf(folder, spec).times.at(0).utc.value()) == "2021-08-14T01:00:00Z");
    spec.calendar = "noleap";
    const DatasetInfo info = infoOf(folder, spec);
    CHECK_FALSE(info.times.at(0).utc);
    CHECK(hasNote(info, "another calendar"));
}

TEST_CASE(
    "Cells of a real run lie where its XLAT and XLONG have them, turned and scaled as it says" *
    doctest::skip(kMappedRun == nullptr)) {
    const auto dataset = openFiles({kMappedRun});
    const DatasetInfo& info = dataset->info();
    REQUIRE(!info.map.projection.empty());
    const auto field = [&](const char* name) {
        return info.find(name) == nullptr ? Array3f() : dataset->read(name, 0);
    };
    const Array3f latitude = field("XLAT"), longitude = field("XLONG"), factor = field("MAPFAC_M");
    const Array3f sine = field("SINALPHA"), cosine = field("COSALPHA");
    const MapPlace place(info.map);
    double worst = 0.0, worstTurnDeg = 0.0, worstFactor = 0.0;
    for (int y = 0; y < info.size.y; ++y) {
        for (int x = 0; x < info.size.x; ++x) {
            const auto at = [&](const Array3f& of) {
                return of.empty() ? std::nan("") : static_cast<double>(of.at(x, y, 0));
            };
            const auto point = place.at((glm::dvec2(x, y) + 0.5) * info.spacingM);
            REQUIRE(point);
            const double alphaDeg = glm::degrees(std::atan2(at(sine), at(cosine)));
            worst = std::max(worst, distanceM(point->geo, {at(latitude), at(longitude)}));
            const double turnDeg =
                std::abs(std::remainder(point->convergenceDeg - alphaDeg, 360.0));
            worstTurnDeg = std::fmax(worstTurnDeg, turnDeg);
            worstFactor = std::fmax(worstFactor, std::abs(point->mapFactor.x / at(factor) - 1.0));
        }
    }
    MESSAGE("largest difference ", worst, " m, ", worstTurnDeg, " degrees, factor ", worstFactor);
    CHECK(worst < 20.0);
    CHECK(worstTurnDeg < 0.01);
    CHECK(worstFactor < 1e-4);
}
