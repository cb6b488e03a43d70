// wrf_moving_test.cpp: nests of WRF that move.
#include <doctest/doctest.h>

#include "core/dataset/whereabouts.h"
#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

TEST_CASE("A nest that moves within a file has its place at each time, in whole cells") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.mapProjection = 6;
    spec.dx = spec.dy = 1111.775f;  // 0.01 degrees on WRF's sphere
    spec.times = {"2010-03-15_12:30:00", "2010-03-15_12:40:00"};
    spec.attributes = {{"POLE_LAT", 90.0}, {"POLE_LON", 0.0}, {"STAND_LON", 0.0}};
    spec.flat["XLAT"] = [](int, int y, int, int t) {
        return static_cast<float>(0.015 + 0.01 * (y - 2 * t));
    };
    spec.flat["XLONG"] = [](int x, int, int, int t) {
        return static_cast<float>(10.0 + 0.01 * (x + 3 * t));
    };
    writeWrf(folder / "a", spec);
    const DatasetInfo info = openFiles({folder / "a"})->info();
    CHECK(info.moves());
    CHECK(info.times[0].gridOffsetM == glm::dvec2(0.0));
    // 3 cells eastwards and 2 southwards, of cells as wide as the description has them.
    CHECK(info.times[1].gridOffsetM.x == doctest::Approx(3.0 * info.spacingM.x).epsilon(1e-12));
    CHECK(info.times[1].gridOffsetM.y == doctest::Approx(-2.0 * info.spacingM.y).epsilon(1e-12));
    CHECK(hasNote(info, "each time has its own place"));
    const auto at = [&](int time) {
        return whereaboutsOf(info, time, 0.5 * info.spacingM).place.value().geo;
    };
    CHECK(at(0).longitudeDeg == doctest::Approx(10.0).epsilon(1e-6));
    CHECK(at(1).longitudeDeg == doctest::Approx(10.03).epsilon(1e-6));
    CHECK(at(1).latitudeDeg == doctest::Approx(-0.005).epsilon(1e-3));
}
