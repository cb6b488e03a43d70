// section_test.cpp: sections, columns and places of data whose values are formulas of position.
#include "core/analysis/section.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/air/thermodynamics.h"
#include "core/analysis/column.h"
#include "core/analysis/figures.h"
#include "core/analysis/place.h"
#include "core/base/error.h"
#include "tests/core/memory_dataset.h"
#include "tests/text.h"

using namespace neph;

namespace {

constexpr glm::ivec3 kSize{12, 10, 40};

/// Columns 500 x 250 m, layers of 250 m above a slope that rises by 10 m a column along x. Winds
/// turn like a solid body; cloud is linear in x, y and height.
MemoryDataset formulas() {
    MemoryDataset data(kSize, [](int x, int, int z) {
        return 10.0f * static_cast<float>(x) + 250.0f * static_cast<float>(z);
    });
    const auto heightM = [](int x, int z) { return 10.0 * x + 250.0 * z + 125.0; };
    data.addRatio(Species::cloud, [=](int x, int y, int z) {
        return static_cast<float>(
            1e-6 * (0.1 * (500.0 * x + 250.0) + 0.2 * (250.0 * y + 125.0) + 0.05 * heightM(x, z)));
    });
    const auto add = [&](const char* name, VariableRole role, const auto& value) {
        data.add(name, role, {}, kSize,
                 [=](int x, int y, int z) { return static_cast<float>(value(x, y, z)); });
    };
    add("p", VariableRole::airPressure,
        [=](int x, int, int z) { return 1e5 * std::exp(-heightM(x, z) / 8000.0); });
    // 6.5 K/km up to 6 km, then isothermal.
    add("t", VariableRole::airTemperature,
        [=](int x, int, int z) { return 290.0 - 0.0065 * std::min(heightM(x, z), 6000.0); });
    add("qv", VariableRole::waterVapour, [](int, int, int) { return 0.005; });
    add("u", VariableRole::xWind, [](int, int y, int) { return -1e-3 * 250.0 * y; });
    add("v", VariableRole::yWind, [](int x, int, int) { return 1e-3 * 500.0 * x; });
    return data;
}

double cloudAt(glm::dvec2 atM, double heightM) {
    return 1e-3 * (0.1 * atM.x + 0.2 * atM.y + 0.05 * heightM);
}

}  // namespace

TEST_CASE("A vertical section of linear values is linear, and empty below the ground") {
    MemoryDataset data = formulas();
    const glm::dvec2 from(600.0, 400.0), to(5200.0, 2100.0);
    const std::array quantities{Quantity::cloud, Quantity::vorticity};
    const CrossSection section = verticalSection(data, 0, from, to, quantities, true);
    REQUIRE(section.fields.size() == 2);
    const double length = glm::distance(from, to);
    int below = 0, inside = 0;
    for (std::size_t i = 0; i < section.acrossM.size(); ++i) {
        const glm::dvec2 at = glm::mix(from, to, section.acrossM[i] / length);
        CHECK(section.groundM[i] == doctest::Approx((at.x - 250.0) / 50.0).epsilon(1e-3));
        CHECK(section.tropopauseM[i] == doctest::Approx(6000.0).epsilon(0.05));
        for (std::size_t k = 0; k < section.upM.size(); ++k) {
            const double height = section.upM[k];
            const auto value = static_cast<double>(section.at(0, i, k));
            if (height < section.groundM[i]) {
                CHECK(std::isnan(value));
                ++below;
            } else if (height > section.groundM[i] + 150.0 && height < 9800.0) {
                CHECK(value == doctest::Approx(cloudAt(at, height)).epsilon(2e-4));
                CHECK(section.at(1, i, k) == doctest::Approx(2.0).epsilon(1e-3));
                ++inside;
            }
        }
    }
    CHECK(below > 0);
    CHECK(inside > 500);
}

TEST_CASE("A vertical section has two heights for each of thin layers") {
    constexpr float kLayerM = 40.0f;
    MemoryDataset data({4, 4, 50},
                       [=](int, int, int z) { return kLayerM * static_cast<float>(z); });
    data.addRatio(Species::cloud, [](int, int, int z) { return z == 20 ? 1e-3f : 0.0f; });
    const std::array quantities{Quantity::cloud};
    const double middle = data.info().edgeM(1, 2);
    const CrossSection section = verticalSection(
        data, 0, {0.0, middle}, {data.info().edgeM(0, 4), middle}, quantities, false);
    CHECK(section.upM.size() == 100);
    // A quarter of a layer from the centre of the only one that is cloudy, of 1 g/kg.
    CHECK(*std::ranges::max_element(section.fields[0].values) ==
          doctest::Approx(0.75).epsilon(1e-4));
}

TEST_CASE("Wind that ends below 6 km, or is missing, gives no shear of 6 km") {
    const auto reportOf = [](float layerM, float windMPerS) {
        constexpr glm::ivec3 kCells{4, 4, 30};
        MemoryDataset data(kCells, [=](int, int, int z) { return layerM * static_cast<float>(z); });
        const auto add = [&](const char* name, VariableRole role, const auto& value) {
            data.add(name, role, {}, kCells, [=](int, int, int z) {
                return static_cast<float>(value(static_cast<double>(layerM) * (z + 0.5)));
            });
        };
        add("p", VariableRole::airPressure, [](double z) { return 1e5 * std::exp(-z / 8000.0); });
        add("t", VariableRole::airTemperature, [](double z) { return 290.0 - 0.0065 * z; });
        add("qv", VariableRole::waterVapour, [](double) { return 0.005; });
        add("u", VariableRole::xWind, [=](double) { return windMPerS; });
        add("v", VariableRole::yWind, [](double z) { return 0.001 * z; });
        return readColumn(data, 0, glm::dvec2(data.info().edgeM(0, 1), data.info().edgeM(1, 1)));
    };
    const ColumnReport shallow = reportOf(100.0f, 5.0f);
    REQUIRE(shallow.wind);
    CHECK(shallow.wind->shear1MPerS);
    CHECK_FALSE(shallow.wind->shear6MPerS);
    CHECK_FALSE(shallow.wind->motion);
    CHECK_FALSE(shallow.wind->helicity1);
    CHECK(contains(shallow.lacks.back(), "their wind ends 3.0 km above the ground"));
    CHECK(hodographFigure(shallow).marks.empty());
    CHECK(hodographFigure(shallow).curves.size() == 2);
    const ColumnReport deep = reportOf(300.0f, 5.0f);
    REQUIRE(deep.wind);
    REQUIRE(deep.wind->shear6MPerS);
    CHECK(deep.wind->shear6MPerS->y == doctest::Approx(5.85).epsilon(1e-4));
    CHECK_FALSE(reportOf(300.0f, std::numeric_limits<float>::quiet_NaN()).wind);
}

TEST_CASE("A horizontal section has the values of its height in every column") {
    MemoryDataset data = formulas();
    const std::array quantities{Quantity::cloud};
    const CrossSection section = horizontalSection(data, 0, 3000.0, quantities);
    for (std::size_t y = 0; y < section.upM.size(); ++y) {
        for (std::size_t x = 0; x < section.acrossM.size(); ++x) {
            CHECK(section.at(0, x, y) ==
                  doctest::Approx(cloudAt({section.acrossM[x], section.upM[y]}, 3000.0))
                      .epsilon(1e-4));
        }
    }
    CHECK_THROWS_WITH_AS(horizontalSection(data, 0, 3e4, quantities),
                         doctest::Contains("there is no air at that height"), Error);
}

TEST_CASE("A quantity that the data lack is an error that names those they have") {
    MemoryDataset data = formulas();
    const std::array quantities{Quantity::upwardWind};
    try {
        horizontalSection(data, 0, 3000.0, quantities);
        FAIL("must throw");
    } catch (const Error& error) {
        CHECK(contains(error.message(), "they have no upward wind"));
        CHECK(contains(error.message(), "cloud, condensate, vapour, wind_speed"));
    }
}

TEST_CASE("A column has every quantity, and what its air can do") {
    MemoryDataset data = formulas();
    const ColumnReport report = readColumn(data, 0, {2300.0, 1300.0});
    CHECK(report.column == glm::ivec2(4, 5));
    CHECK(report.groundM == doctest::Approx(40.0));
    REQUIRE(report.find(Quantity::cloud) != nullptr);
    CHECK(report.find(Quantity::cloud)->values[8] ==
          doctest::Approx(cloudAt(report.positionM, report.heightsM[8])).epsilon(1e-4));
    CHECK(report.find(Quantity::windSpeed)->values[0] ==
          doctest::Approx(std::hypot(1.25, 2.0)).epsilon(1e-5));
    REQUIRE(report.freezingM.size() == 1);
    CHECK(report.freezingM[0] == doctest::Approx((290.0 - 273.15) / 0.0065).epsilon(1e-3));
    REQUIRE(report.tropopauseM);
    CHECK(*report.tropopauseM == doctest::Approx(6000.0).epsilon(0.05));
    REQUIRE(report.convection);
    REQUIRE(report.wind);
    REQUIRE(report.wind->shear6MPerS);
    CHECK(glm::length(*report.wind->shear6MPerS) == doctest::Approx(0.0));
    CHECK(report.find(Quantity::upwardWind) == nullptr);
    const plot::Table table = columnTable(report);
    CHECK(table.columns.size() == report.profiles.size() + 1);
}

TEST_CASE("The mouse over a skew-T reads pressure and temperature") {
    MemoryDataset data = formulas();
    const plot::Figure figure =
        skewTFigure(readColumn(data, 0, {2300.0, 1300.0}), ParcelSource::surface, "", "");
    REQUIRE(figure.meaning);
    CHECK(figure.meaning({20.0, 0.0}) == "1050 hPa, 20.0 °C");
    // Isotherms lean: the upper end of that of -60 °C is at 25 on the axis below.
    CHECK(figure.meaning({25.0, 1.0}) == "100 hPa, -60.0 °C");
}

TEST_CASE("Places are read as people write them") {
    const auto geo = parsePlace("35.2N, 97.4 w");
    REQUIRE(geo);
    REQUIRE(geo->geo);
    CHECK(geo->geo->latitudeDeg == 35.2);
    CHECK(geo->geo->longitudeDeg == -97.4);
    const auto grid = parsePlace("12.5,40");
    REQUIRE(grid);
    CHECK_FALSE(grid->geo);
    CHECK(grid->positionM == glm::dvec2(12500.0, 40000.0));
    for (const char* text : {"", "12", "12,", "95N,20E", "a,b", "35N,97", "1,2,3"}) {
        CAPTURE(text);
        CHECK_FALSE(parsePlace(text));
    }
}

TEST_CASE("A place outside the domain, or without a map, is refused with what there is") {
    MemoryDataset data = formulas();
    CHECK(positionOf(*parsePlace("6,2.5"), data, 0, "--at") == glm::dvec2(6000.0, 2500.0));
    CHECK(columnAt(data.info(), {6000.0, 2500.0}) == glm::ivec2(11, 9));
    CHECK_THROWS_WITH_AS(positionOf(*parsePlace("6.1,2"), data, 0, "--at"),
                         doctest::Contains("0 to 6, 0 to 2.5 km"), Error);
    CHECK_THROWS_WITH_AS(positionOf(*parsePlace("35N,97W"), data, 0, "--at"),
                         doctest::Contains("no place on the earth"), Error);
}
