// grib_grid_test.cpp: where GRIB2 grids lie, against the positions that ecCodes gives.
#include <doctest/doctest.h>

#include <cmath>

#include "core/geo/map_place.h"
#include "tests/readers/grib_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

/// Calls `check` with where the data set puts the centre of every cell, in the order of the
/// message.
template <typename Check>
void forPlaces(const std::filesystem::path& path, const GribSpec& spec, Check check) {
    const auto dataset = openFiles({path});
    const DatasetInfo& info = dataset->info();
    const MapPlace place(info.map);
    for (const auto& cell : gribOrder(spec)) {
        const auto at = place.geoAt(info.spacingM * (glm::dvec2(cell[0], cell[1]) + 0.5));
        REQUIRE(at.has_value());
        check(*at, cell[0], cell[1]);
    }
}

double apartDeg(const GeoPoint& a, double latitude, double longitude) {
    return std::max(std::abs(a.latitudeDeg - latitude),
                    std::abs(std::remainder(a.longitudeDeg - longitude, 360.0)));
}

GribSpec gridSpec(const char* grid) {
    GribSpec spec;
    spec.nx = 60;
    spec.ny = 40;
    spec.nz = 2;
    spec.grid = grid;
    return spec;
}

}  // namespace

TEST_CASE("GRIB2 grids lie where ecCodes puts their points") {
    const TemporaryFolder folder;
    for (const char* grid : {"lambert", "regular_ll", "mercator"}) {
        for (const int mode : {0, 1, 2, 3}) {
            CAPTURE(grid);
            CAPTURE(mode);
            // ecCodes 2.28 finds no points of the others in other directions.
            if (std::string(grid) != "regular_ll" && mode != 0) continue;
            GribSpec spec = gridSpec(grid);
            spec.northward = (mode & 1) == 0;
            spec.westward = (mode & 2) != 0;
            writeGrib(folder / "a", spec);
            const GribPoints points = gribPoints(folder / "a", 0);
            double most = 0.0;
            std::size_t i = 0;
            forPlaces(folder / "a", spec, [&](const GeoPoint& at, int, int) {
                most = std::max(most, apartDeg(at, points.latitude[i], points.longitude[i]));
                ++i;
            });
            CHECK(most < 3e-6);  // corners are stored in millionths of a degree
        }
    }
}

// ecCodes 2.28 puts points of these up to 0.02 and 4e-6 degrees off the equations.
TEST_CASE("Polar stereographic and rotated GRIB2 grids lie where their equations put them") {
    const TemporaryFolder folder;
    constexpr double kRadiusM = 6371229.0;
    for (const double sign : {1.0, -1.0}) {
        CAPTURE(sign);
        GribSpec spec = gridSpec("polar_stereographic");
        if (sign < 0.0) {
            spec.keys = {{"projectionCentreFlag", 128}, {"latitudeOfFirstGridPoint", -36000000}};
        }
        writeGrib(folder / "polar", spec);
        // WRF's ijll_ps: a plane that cuts the sphere at 38.5 degrees, longitude 262.5 upright.
        const double scale = kRadiusM * (1.0 + std::sin(glm::radians(38.5)));
        const double firstRadius = scale * std::tan(glm::radians(0.5 * (90.0 - 36.0)));
        const double turn = glm::radians(260.0 - 262.5);
        const double west = firstRadius * std::sin(turn);
        const double south = -sign * firstRadius * std::cos(turn);
        forPlaces(folder / "polar", spec, [&](const GeoPoint& at, int x, int y) {
            const double east = west + 3000.0 * x, north = south + 3000.0 * y;
            const double chi = 2.0 * std::atan(std::hypot(east, north) / scale);
            REQUIRE(apartDeg(at, sign * (90.0 - glm::degrees(chi)),
                             262.5 + glm::degrees(std::atan2(east, -sign * north))) < 1e-8);
        });
    }
    for (const int mode : {0, 1, 2, 3}) {
        CAPTURE(mode);
        GribSpec spec = gridSpec("rotated_ll");
        spec.northward = (mode & 1) == 0;
        spec.westward = (mode & 2) != 0;
        writeGrib(folder / "rotated", spec);
        // The rotated north pole lies at 55 N 82 E.
        const double pole = glm::radians(55.0);
        forPlaces(folder / "rotated", spec, [&](const GeoPoint& at, int x, int y) {
            const double latitude = glm::radians(0.03 * y), longitude = glm::radians(0.03 * x);
            const double a = std::cos(latitude) * std::cos(longitude), c = std::sin(latitude);
            const double b = std::cos(latitude) * std::sin(longitude);
            const double up = std::asin(std::sin(pole) * c + std::cos(pole) * a);
            const double east = std::atan2(b, std::sin(pole) * a - std::cos(pole) * c);
            REQUIRE(apartDeg(at, glm::degrees(up), 262.0 + glm::degrees(east)) < 1e-8);
        });
    }
}

TEST_CASE("Cells of GRIB2 grids are as wide as on the earth in the mean") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.grid = "regular_ll";
    writeGrib(folder / "degrees", spec);
    const auto degrees = openFiles({folder / "degrees"});
    // 0.03 degrees on 6371229 m, by four rows from 35 N on.
    const double north = 6371229.0 * glm::radians(0.03);
    double share = 0.0;
    for (int row = 0; row < 4; ++row) share += 0.25 * std::cos(glm::radians(35.0 + 0.03 * row));
    CHECK(degrees->info().spacingM.y == doctest::Approx(north).epsilon(1e-9));
    CHECK(degrees->info().spacingM.x == doctest::Approx(north * share).epsilon(1e-9));
    CHECK(hasNote(degrees->info(), "0.03 x 0.03 degrees"));
    spec.grid = "lambert";
    writeGrib(folder / "lambert", spec);
    const auto lambert = openFiles({folder / "lambert"});
    const DatasetInfo& info = lambert->info();
    const MapPlace place(info.map);
    const double factor = place.at(0.5 * info.extentM())->mapFactor.x;
    CHECK(factor > 1.0005);  // 36 N, 2.5 degrees south of where the cone touches
    CHECK(info.spacingM.x == doctest::Approx(3000.0 / factor).epsilon(1e-5));
}

TEST_CASE("GRIB2 grids without even rows and columns are refused with a step") {
    const TemporaryFolder folder;
    struct Case {
        const char* sample;
        const char* found;
    };
    for (const Case& c :
         {Case{"regular_gg_ml_grib2", "Gaussian"}, Case{"reduced_gg_ml_grib2", "Gaussian"},
          Case{"sh_ml_grib2", "spherical"}}) {
        CAPTURE(c.sample);
        writeGribSample(folder / "a", c.sample);
        const ErrorParts error = openError(folder / "a");
        CHECK(contains(error.found, c.found));
        CHECK(contains(error.hint, "wgrib2 IN -new_grid"));
        CHECK(contains(error.hint, "cdo"));
    }
    GribSpec spec;
    spec.keys["scanningMode"] = 64 + 8;
    writeGrib(folder / "offset", spec);  // every other row half a cell to the side
    const ErrorParts offset = openError(folder / "offset");
    CHECK(contains(offset.what, "message 1, CIMIXR on hybrid level 1: "));
    CHECK(contains(offset.what, "set off"));
}
