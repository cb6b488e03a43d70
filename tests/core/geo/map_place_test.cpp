// map_place_test.cpp: against corners that WRF's own tools computed, and closed forms of the
// projections.
#include "core/geo/map_place.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "core/base/error.h"
#include "tests/text.h"

using namespace neph;

namespace {

/// A domain of WPS, and the latitudes and longitudes of its south-west, north-west, north-east and
/// south-east cells, which geogrid writes as corner_lats and corner_lons.
struct Domain {
    const char* name;
    const char* projection;
    int nx, ny;
    double stepM;
    std::array<GeoPoint, 4> corners;
};

const Domain kDomains[]{
    // WPS User's Guide, description of geogrid's global attributes.
    {"Lambert, secant",
     "+proj=lcc +lat_1=30 +lat_2=60 +lat_0=34.83 +lon_0=-98 +R=6370000",
     73,
     60,
     30000.0,
     {{{28.17127, -93.64893},
       {44.36657, -92.39661},
       {39.63231, -66.00165},
       {24.61906, -72.64047}}}},
    // A met_em file of metgrid 4.6.0 over eastern Asia, quoted in public.
    {"Lambert, tangent",
     "+proj=lcc +lat_1=33.87 +lat_2=33.87 +lat_0=33.87 +lon_0=102.186 +R=6370000",
     151,
     117,
     54000.0,
     {{{1.56295, 69.9118}, {50.91934, 43.32767}, {51.36064, 159.9401}, {1.790321, 133.7513}}}},
    // A geo_em file of geogrid 4.5 over Alaska, quoted in public.
    {"polar stereographic",
     "+proj=stere +lat_0=90 +lat_ts=64 +lon_0=-152 +R=6370000",
     420,
     450,
     4000.0,
     {{{55.13433, -164.9492},
       {70.42133, -176.0684},
       {70.51836, -128.5916},
       {55.18422, -139.4365}}}},
};

/// A place whose first cell of `stepM` is centred on a point.
MapPlace placeFrom(const std::string& projection, GeoPoint first, double stepM) {
    MapGrid grid{.projection = projection};
    const auto atM = MapPlace(grid).positionM(first);
    REQUIRE(atM);
    grid.originM = *atM - 0.5 * stepM;
    return MapPlace(grid);
}

PlacePoint pointAt(const std::string& projection, GeoPoint geo) {
    const MapPlace place({.projection = projection});
    const auto atM = place.positionM(geo);
    REQUIRE(atM);
    const auto point = place.at(*atM);
    REQUIRE(point);
    CHECK(point->geo.latitudeDeg == doctest::Approx(geo.latitudeDeg));
    CHECK(point->geo.longitudeDeg == doctest::Approx(geo.longitudeDeg));
    return *point;
}

double rad(double degrees) {
    return glm::radians(degrees);
}

std::string faultOf(const MapGrid& grid) {
    try {
        const MapPlace place(grid);
    } catch (const Error& error) {
        return error.parts().what;
    }
    return {};
}

}  // namespace

TEST_CASE(
    "Corners of domains lie where WRF's preprocessor puts them, within its single precision") {
    for (const Domain& domain : kDomains) {
        CAPTURE(domain.name);
        const MapPlace place = placeFrom(domain.projection, domain.corners[0], domain.stepM);
        const glm::dvec2 last = domain.stepM * (glm::dvec2(domain.nx, domain.ny) - 0.5);
        const double first = 0.5 * domain.stepM;
        const std::array<glm::dvec2, 4> cells{
            {{first, first}, {first, last.y}, {last.x, last.y}, {last.x, first}}};
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto expectedM = place.positionM(domain.corners[i]);
            REQUIRE(expectedM);
            CHECK(glm::length(*expectedM - cells[i]) < 6.0);
            const auto geo = place.geoAt(cells[i]);
            REQUIRE(geo);
            CHECK(std::abs(geo->latitudeDeg - domain.corners[i].latitudeDeg) < 1e-4);
            CHECK(std::abs(geo->longitudeDeg - domain.corners[i].longitudeDeg) < 1e-4);
        }
    }
}

TEST_CASE("True north and map factor of a Lambert map are those of its cone") {
    // [Snyder87] eq. 15-3, 15-4 and the scale factor of 15-1, on a sphere.
    const double n = std::log(std::cos(rad(30.0)) / std::cos(rad(60.0))) /
                     std::log(std::tan(rad(75.0)) / std::tan(rad(60.0)));
    const PlacePoint east =
        pointAt("+proj=lcc +lat_1=30 +lat_2=60 +lat_0=35 +lon_0=-98 +R=6370000", {35.0, -78.0});
    CHECK(east.convergenceDeg == doctest::Approx(-20.0 * n));
    const double factor = std::cos(rad(30.0)) * std::pow(std::tan(rad(60.0)), n) /
                          (std::cos(rad(35.0)) * std::pow(std::tan(rad(62.5)), n));
    CHECK(east.mapFactor.x == doctest::Approx(factor));
    CHECK(east.mapFactor.y == doctest::Approx(factor));
    // In the south the cone opens the other way.
    const PlacePoint south =
        pointAt("+proj=lcc +lat_1=-30 +lat_2=-60 +lat_0=-35 +lon_0=-98 +R=6370000", {-35.0, -78.0});
    CHECK(south.convergenceDeg == doctest::Approx(20.0 * n));
    CHECK(south.mapFactor.x == doctest::Approx(factor));
}

TEST_CASE("True north and map factor of polar, Mercator and latitude-longitude maps are exact") {
    // [Snyder87] eq. 21-34, 7-1 and 12-1 with their scale factors.
    const double polar = (1.0 + std::sin(rad(60.0))) / (1.0 + std::sin(rad(75.0)));
    const PlacePoint north =
        pointAt("+proj=stere +lat_0=90 +lat_ts=60 +lon_0=10 +R=6370000", {75.0, 50.0});
    CHECK(north.convergenceDeg == doctest::Approx(-40.0));
    CHECK(north.mapFactor.x == doctest::Approx(polar));
    const PlacePoint south =
        pointAt("+proj=stere +lat_0=-90 +lat_ts=-60 +lon_0=10 +R=6370000", {-75.0, 50.0});
    CHECK(south.convergenceDeg == doctest::Approx(40.0));
    CHECK(south.mapFactor.y == doctest::Approx(polar));

    const PlacePoint mercator = pointAt("+proj=merc +lat_ts=20 +lon_0=0 +R=6370000", {45.0, 50.0});
    CHECK(std::abs(mercator.convergenceDeg) < 1e-6);
    CHECK(mercator.mapFactor.x == doctest::Approx(std::cos(rad(20.0)) / std::cos(rad(45.0))));
    CHECK(mercator.mapFactor.y == doctest::Approx(mercator.mapFactor.x));

    const PlacePoint plain = pointAt("+proj=eqc +lon_0=0 +R=6370000", {60.0, 50.0});
    CHECK(std::abs(plain.convergenceDeg) < 1e-6);
    CHECK(plain.mapFactor.x == doctest::Approx(2.0));
    CHECK(plain.mapFactor.y == doctest::Approx(1.0));
}

TEST_CASE("A map in metres of the grid is stretched by the stated factor") {
    MapGrid grid{.projection = "+proj=merc +lon_0=0 +R=6370000",
                 .originM = {1000.0, 2000.0},
                 .mapPerGrid = {2.0, 4.0}};
    const auto geo = MapPlace(grid).geoAt({500.0, 250.0});
    REQUIRE(geo);
    // Near the equator a metre of Mercator's map is a metre.
    CHECK(geo->longitudeDeg == doctest::Approx(glm::degrees(2000.0 / 6370000.0)));
    CHECK(geo->latitudeDeg == doctest::Approx(glm::degrees(3000.0 / 6370000.0)));
    const auto back = MapPlace(grid).positionM(*geo);
    REQUIRE(back);
    CHECK(glm::length(*back - glm::dvec2(500.0, 250.0)) < 1e-3);
}

TEST_CASE("Beyond the edge of a map there is no place, and at a pole north is that of its side") {
    const MapPlace disc({.projection = "+proj=ortho +lat_0=40 +lon_0=0 +R=6370000"});
    CHECK(disc.geoAt({0.0, 0.0}));
    CHECK_FALSE(disc.positionM({-40.0, 180.0}));
    CHECK_FALSE(disc.geoAt({7e6, 0.0}));
    CHECK_FALSE(disc.at({7e6, 0.0}));
    const MapPlace pole({.projection = "+proj=stere +lat_0=90 +lat_ts=60 +lon_0=0 +R=6370000"});
    CHECK(pole.geoAt({0.0, 0.0})->latitudeDeg == doctest::Approx(90.0));
    const auto beside = pole.at({0.0, 0.0});
    REQUIRE(beside);
    CHECK(beside->geo.latitudeDeg == doctest::Approx(90.0).epsilon(1e-4));
    // On this map north lies towards the pole: in the west of a place to its east.
    CHECK(beside->convergenceDeg == doctest::Approx(-90.0));
}

TEST_CASE("A projection that is unknown, impossible or in need of files is refused with a reason") {
    CHECK(contains(faultOf({.projection = "+proj=nonsense"}), "cannot be used"));
    CHECK(contains(faultOf({.projection = "EPSG:3857"}), "+proj"));
    CHECK(contains(faultOf({.projection = "+init=epsg:3857"}), "+proj"));
    CHECK(contains(faultOf({.projection = "+proj=merc +nadgrids=conus"}), "grids="));
    CHECK(contains(faultOf({.projection = "+proj=merc +nadgrids=../../etc"}), "+key=value"));
    CHECK(contains(faultOf({.projection = "+proj=pipeline +step +proj=merc"}), "pipeline"));
    CHECK(contains(faultOf({.projection = "+proj=merc +R=6370000 +units=km"}), "metres"));
    CHECK(contains(faultOf({.projection = "+proj=longlat +R=6370000"}), "metres"));
    CHECK(contains(faultOf({.projection = "+proj=merc +R=-1"}), "cannot be used"));
    CHECK(contains(faultOf({.projection = "+proj=merc " + std::string(2000, ' ')}), "too long"));
    const std::string good = "+proj=merc +R=6370000 +units=m";
    CHECK(faultOf({.projection = good}).empty());
    CHECK(contains(faultOf({.projection = good, .mapPerGrid = {0.0, 1.0}}), "0 x 1 m"));
    CHECK(contains(faultOf({.projection = good, .originM = {NAN, 1.0}}), "nan"));
}
