// series_test.cpp: maxima, masses, heights and cover of made data and of the bundled storm.
#include "core/analysis/series.h"

#include <doctest/doctest.h>

#include "core/analysis/figures.h"
#include "tests/core/memory_dataset.h"
#include "tests/text.h"

using namespace neph;

namespace {

constexpr glm::ivec3 kColumns{10, 8, 20};

/// Layers of 100 m; cloud in two of ten columns along x from 1 km up to 1.8 km.
MemoryDataset twoColumns() {
    MemoryDataset data(kColumns, [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    data.addRatio(Species::cloud, [](int x, int y, int z) {
        if (x == 3 && y == 2 && z == 12) return 4e-3f;
        return (x == 3 || x == 4) && z >= 10 && z < 18 ? 1e-3f : 0.0f;
    });
    data.add("w", VariableRole::upwardWind, {}, kColumns, [](int x, int y, int z) {
        return x == 9 && y == 7 && z == 5 ? 12.0f : x == 0 && y == 0 && z == 0 ? -3.0f : 0.5f;
    });
    return data;
}

}  // namespace

TEST_CASE("A point of a series has what is largest and where, and the sums") {
    MemoryDataset data = twoColumns();
    const SeriesPoint point = readSeriesPoint(data, 0);
    REQUIRE(point.mostGPerKg[0]);
    CHECK(point.mostGPerKg[0]->value == doctest::Approx(4.0));
    CHECK(point.mostGPerKg[0]->positionM == glm::dvec3(1750.0, 625.0, 1250.0));
    CHECK_FALSE(point.mostGPerKg[1]);
    REQUIRE(point.updraftMPerS);
    CHECK(point.updraftMPerS->value == 12.0);
    CHECK(point.updraftMPerS->positionM == glm::dvec3(4750.0, 1875.0, 550.0));
    CHECK(point.downdraftMPerS->value == -3.0);
    CHECK(point.cover == doctest::Approx(0.2));
    CHECK(*point.stormTopM == doctest::Approx(1800.0));
    CHECK(*point.baseM == doctest::Approx(1000.0));
    // 16 columns of 500 x 250 m; density as MemoryDataset has it.
    double expected = 0.0;
    for (int z = 10; z < 18; ++z) {
        const double density = 1.2 * std::exp(-(100.0 * z + 50.0) / 7200.0);
        expected += density * 100.0 * 500.0 * 250.0 * (16 * 1e-3 + (z == 12 ? 3e-3 : 0.0));
    }
    REQUIRE(point.massKg[0]);
    CHECK(*point.massKg[0] == doctest::Approx(expected).epsilon(1e-4));
}

TEST_CASE("A series is a table with a row a time, and plots of what it has") {
    MemoryDataset data = twoColumns();
    data.addTime("2024-05-06_21:10:00", "memory");
    const std::vector<SeriesPoint> points{readSeriesPoint(data, 0), readSeriesPoint(data, 1)};
    const plot::Table table = seriesTable(points, {"a", "b"});
    const std::string csv = plot::csvOf(table);
    CHECK(contains(csv, "cloud max [g/kg],cloud max at x [m]"));
    CHECK(contains(csv, "w max [m/s]"));
    CHECK_FALSE(contains(csv, "rain"));
    CHECK(contains(csv, "\nb,600,4,"));
    for (int i = 0; i < kSeriesKinds; ++i) {
        const plot::Figure figure = seriesFigure(points, static_cast<SeriesKind>(i), "t");
        CHECK_FALSE(figure.curves.empty());
        CHECK(figure.x.to == 10.0);
    }
}
