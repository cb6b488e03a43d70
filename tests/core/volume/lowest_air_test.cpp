// lowest_air_test.cpp: the mean humidity of the layer at the ground.
#include "core/volume/lowest_air.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/optics/aerosol.h"
#include "core/volume/held_volume.h"
#include "tests/core/memory_dataset.h"
#include "tests/text.h"

using namespace neph;

namespace {

/// Humid in the west of the lowest layer and drier in the east; other air above.
MemoryDataset humidAir() {
    MemoryDataset dataset({2, 2, 2},
                          [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    dataset.addRatio(Species::cloud, [](int, int, int) { return 1e-4f; });
    const glm::ivec3 size(2, 2, 2);
    dataset.add("p", VariableRole::airPressure, {}, size,
                [](int, int, int z) { return z == 0 ? 1e5f : 5e4f; });
    dataset.add("T", VariableRole::airTemperature, {}, size, [](int, int, int) { return 298.15f; });
    dataset.add("qv", VariableRole::waterVapour, {}, size, [](int x, int, int z) {
        return z == 1 ? 0.0f : x == 0 ? 0.014f : 0.007f;
    });
    return dataset;
}

// Of 1e5 Pa, 25 °C and 14 and 7 g/kg: 1e5 q / (0.622 + q) / 3168.99 Pa.
constexpr double kWest = 0.694967, kEast = 0.351350;

}  // namespace

TEST_CASE("The humidity of the lowest air is the mean over the layer at the ground") {
    MemoryDataset dataset = humidAir();
    const LowestAir air = readLowestAir(dataset, 0);
    REQUIRE(air.humidity.has_value());
    CHECK(*air.humidity == doctest::Approx(0.5 * (kWest + kEast)).epsilon(1e-5));
    CHECK(air.reason.empty());
    dataset.stretch({0.0, 100.0, 400.0}, {0.0, 100.0, 200.0});
    CHECK(*readLowestAir(dataset, 0).humidity ==
          doctest::Approx(0.25 * kWest + 0.75 * kEast).epsilon(1e-5));
}

TEST_CASE("A profile of pressure or temperature counts for every column") {
    MemoryDataset dataset = humidAir();
    dataset.stated().variables.pop_back();
    std::erase_if(dataset.stated().variables, [](const auto& v) { return v.name == "p"; });
    dataset.add("qv2", VariableRole::waterVapour, {}, {2, 2, 2},
                [](int x, int, int) { return x == 0 ? 0.014f : 0.007f; });
    dataset.add("pref", VariableRole::airPressure, {}, {1, 1, 2},
                [](int, int, int z) { return z == 0 ? 1e5f : 5e4f; });
    CHECK(*readLowestAir(dataset, 0).humidity ==
          doctest::Approx(0.5 * (kWest + kEast)).epsilon(1e-5));
}

TEST_CASE("What is supersaturated counts as saturated") {
    MemoryDataset dataset = humidAir();
    dataset.stated().variables.pop_back();
    dataset.add("qv2", VariableRole::waterVapour, {}, {2, 2, 2},
                [](int x, int, int) { return x == 0 ? 0.03f : 0.0f; });
    CHECK(*readLowestAir(dataset, 0).humidity == doctest::Approx(0.5));
}

TEST_CASE("Without vapour, pressure or temperature there is no humidity but a reason") {
    struct Case {
        const char *name, *reason;
    };
    for (const Case& each : {Case{"qv", "the data have no water vapour"},
                             Case{"p", "the data have no pressure of the air"},
                             Case{"T", "the data have no temperature of the air"}}) {
        CAPTURE(each.name);
        MemoryDataset dataset = humidAir();
        std::erase_if(dataset.stated().variables,
                      [&](const VariableInfo& variable) { return variable.name == each.name; });
        const LowestAir air = readLowestAir(dataset, 0);
        CHECK_FALSE(air.humidity.has_value());
        CHECK(air.reason == each.reason);
    }
    MemoryDataset dataset = humidAir();
    dataset.addTime("2024-05-06_21:10:00", "second", {"qv"});
    CHECK(readLowestAir(dataset, 0).humidity.has_value());
    CHECK(readLowestAir(dataset, 1).reason == "there is no water vapour at this time");
}

TEST_CASE("The extinction of the lowest air is that of its aerosol, each cell at its humidity") {
    MemoryDataset dataset = humidAir();
    CHECK(readLowestAir(dataset, 0).noAerosol == "the data have no number of hygroscopic aerosol");
    const auto number = [](float perKg) {
        return [perKg](int x, int, int z) { return z == 1 ? 9e9f : x == 0 ? perKg : -1.0f; };
    };
    dataset.add("nwfa", VariableRole::hygroscopicAerosolNumber, {}, {2, 2, 2}, number(2e9f));
    CHECK(readLowestAir(dataset, 0).noAerosol == "the data have no number of dust");
    dataset.add("nifa", VariableRole::dustNumber, {}, {2, 2, 2}, number(1e6f));
    const LowestAir air = readLowestAir(dataset, 0);
    REQUIRE(air.aerosolPerM.has_value());
    CHECK(air.noAerosol.empty());
    // Half of the air has aerosol, at its own humidity. Density by 1e5 / (287 T (1 + q / 0.622)).
    const double density = 1e5 / (287.0 * 298.15 * (1.0 + 0.014 / 0.622));
    const double west = density * (2e9 * meanExtinctionM2(kHygroscopicAerosol, kWest) +
                                   1e6 * meanExtinctionM2(kDustAerosol, kWest));
    CHECK(*air.aerosolPerM == doctest::Approx(0.5 * west).epsilon(1e-3));
    dataset.addTime("2024-05-06_21:10:00", "second", {"nifa"});
    CHECK(readLowestAir(dataset, 1).noAerosol == "there is no number of dust at this time");
    CHECK(readLowestAir(dataset, 1).humidity.has_value());
}

TEST_CASE("Aerosol is not known without humidity, nor where it is missing in a cell") {
    MemoryDataset dataset = humidAir();
    const auto add = [&](const char* name, VariableRole role, float perKg) {
        dataset.add(name, role, {}, {2, 2, 2}, [perKg](int, int, int) { return perKg; });
    };
    add("nwfa", VariableRole::hygroscopicAerosolNumber, 1e9f);
    add("nifa", VariableRole::dustNumber, std::numeric_limits<float>::quiet_NaN());
    const LowestAir missing = readLowestAir(dataset, 0);
    CHECK(missing.humidity.has_value());
    CHECK_FALSE(missing.aerosolPerM.has_value());
    CHECK(contains(missing.noAerosol, "variable nifa is unusable"));
    std::erase_if(dataset.stated().variables, [](const auto& v) { return v.name == "qv"; });
    CHECK(readLowestAir(dataset, 0).noAerosol == "the data have no water vapour");
}

TEST_CASE("Vapour that is missing in a cell gives no humidity but the cell") {
    MemoryDataset dataset = humidAir();
    dataset.stated().variables.pop_back();
    dataset.add("qv2", VariableRole::waterVapour, {}, {2, 2, 2}, [](int x, int, int) {
        return x == 1 ? std::numeric_limits<float>::quiet_NaN() : 0.01f;
    });
    const LowestAir air = readLowestAir(dataset, 0);
    CHECK_FALSE(air.humidity.has_value());
    CHECK(contains(air.reason, "variable qv2 is unusable"));
    CHECK(contains(air.reason, "cell x 1, y 0, level 0"));
}

TEST_CASE("A volume has the humidity where it is asked for, and nothing is read for it otherwise") {
    MemoryDataset dataset = humidAir();
    const HeldVolume without = readVolume(dataset, 0, {});
    CHECK_FALSE(without.summary.where.humidity.has_value());
    CHECK(dataset.reads("qv") == 0);
    VolumeRequest request;
    request.humidity = true;
    const HeldVolume held = readVolume(dataset, 0, request);
    CHECK(*held.summary.where.humidity == doctest::Approx(0.5 * (kWest + kEast)).epsilon(1e-5));
    CHECK(dataset.reads("qv") == 1);
    // The whole domain, whatever is shown of it.
    request.region = BoxM{{0.0, 0.0, 0.0}, {500.0, 500.0, 200.0}};
    CHECK(*readVolume(dataset, 0, request).summary.where.humidity == *held.summary.where.humidity);
}
