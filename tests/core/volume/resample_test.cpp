// resample_test.cpp: mass is conserved, nothing overshoots, and bad columns are told apart from
// empty ones.
#include "core/volume/resample.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <random>

#include "core/base/error.h"
#include "core/volume/native_band.h"
#include "tests/core/memory_dataset.h"

using namespace neph;

namespace {

/// Stretched layers over terrain: 60 m at the ground to several hundred aloft, squeezed over a
/// hill.
float hillHeight(int x, int y, int z) {
    const float ground = 300.0f + 40.0f * static_cast<float>((x * 7 + y * 3) % 11);
    const float s = static_cast<float>(z) / 24.0f;
    return ground + (12000.0f - ground) * (0.12f * s + 0.88f * s * s);
}

double nativeColumn(Dataset& dataset, const std::string& ratio, int x, int y) {
    const Array3f z = dataset.read("z", 0), rho = dataset.read("rho", 0),
                  q = dataset.read(ratio, 0);
    double mass = 0.0;
    for (int k = 0; k < q.size.z; ++k) {
        mass += static_cast<double>(q.at(x, y, k)) * static_cast<double>(rho.at(x, y, k)) *
                (static_cast<double>(z.at(x, y, k + 1)) - static_cast<double>(z.at(x, y, k)));
    }
    return mass;
}

double targetColumn(const SpeciesVolume& volume, Species species, int x, int y) {
    double mass = 0.0;
    for (int k = 0; k < volume.grid.size.z; ++k) {
        mass += static_cast<double>(volume.content(species).at(x, y, k)) * volume.grid.spacingM.z;
    }
    return mass;
}

/// Everything at full resolution on `levels` levels over the same depth.
ReadPlan withLevels(Dataset& dataset, int levels) {
    ReadPlan plan = planRead(dataset, 0);
    plan.grid.spacingM.z *= static_cast<double>(plan.grid.size.z) / levels;
    plan.grid.size.z = levels;
    return plan;
}

std::vector<double> onto(const std::vector<double>& interfaces, const std::vector<double>& content,
                         double bottom, double spacing, std::size_t levels) {
    std::vector<double> target(levels, 0.0);
    resampleColumn(interfaces, content, bottom, spacing, target);
    return target;
}

}  // namespace

TEST_CASE("Column mass is conserved to 1e-6 for every species, over terrain and stretched layers") {
    MemoryDataset dataset({9, 8, 24}, hillHeight);
    std::mt19937 random(20030405);
    std::uniform_real_distribution<float> uniform(0.0f, 5e-3f);
    for (int s = 0; s < kSpeciesCount; ++s) {
        dataset.addRatio(static_cast<Species>(s), [&](int, int, int z) {
            return z % (s + 2) == 0 ? 0.0f : uniform(random);
        });
    }
    for (const int levels : {7, 24, 100, 256}) {
        CAPTURE(levels);
        const SpeciesVolume volume = resample(dataset, 0, {withLevels(dataset, levels)});
        for (int s = 0; s < kSpeciesCount; ++s) {
            const auto species = static_cast<Species>(s);
            const std::string name = "Q_" + std::string(info(species).id);
            for (int y = 0; y < 8; ++y) {
                for (int x = 0; x < 9; ++x) {
                    CHECK(targetColumn(volume, species, x, y) ==
                          doctest::Approx(nativeColumn(dataset, name, x, y)).epsilon(1e-6));
                }
            }
        }
    }
}

TEST_CASE("Uniform content stays uniform wherever a target layer is full of air") {
    const std::vector<double> interfaces{0.0, 50.0, 170.0, 400.0, 900.0};
    const std::vector<double> target = onto(interfaces, {2.0, 2.0, 2.0, 2.0}, 0.0, 90.0, 10);
    for (const double value : target) CHECK(value == doctest::Approx(2.0).epsilon(1e-12));
}

TEST_CASE("A straight line of content is carried over exactly away from its ends") {
    std::vector<double> interfaces, content;
    for (int k = 0; k <= 20; ++k) interfaces.push_back(100.0 * k);
    for (int k = 0; k < 20; ++k) content.push_back(1.0 + 0.01 * (100.0 * k + 50.0));
    const std::vector<double> target = onto(interfaces, content, 0.0, 40.0, 50);
    for (std::size_t k = 5; k < 45; ++k) {
        const double centre = 40.0 * static_cast<double>(k) + 20.0;
        CHECK(target[k] == doctest::Approx(1.0 + 0.01 * centre).epsilon(1e-12));
    }
}

TEST_CASE("Nothing overshoots: target values lie within the native ones of their neighbourhood") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> depth(20.0, 300.0);
    std::uniform_real_distribution<double> value(0.0, 1.0);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> interfaces{0.0}, content;
        for (int k = 0; k < 15; ++k) {
            interfaces.push_back(interfaces.back() + depth(random));
            content.push_back(trial % 3 == 0 && k % 4 != 0 ? 0.0 : value(random));
        }
        const double top = interfaces.back();
        const auto most = *std::ranges::max_element(content);
        for (const double x : onto(interfaces, content, 0.0, top / 61.0, 61)) {
            CHECK(x >= 0.0);
            CHECK(x <= most * (1.0 + 1e-12));
        }
    }
}

TEST_CASE("One full layer among empty ones stays where it is") {
    const std::vector<double> target =
        onto({0.0, 100.0, 200.0, 300.0}, {0.0, 6.0, 0.0}, 0.0, 50.0, 6);
    CHECK(target == std::vector<double>{0.0, 0.0, 6.0, 6.0, 0.0, 0.0});
}

TEST_CASE("A thin layer fills its share of a deep target layer") {
    const std::vector<double> target =
        onto({0.0, 10.0, 30.0, 100.0}, {0.0, 4.0, 0.0}, 0.0, 100.0, 1);
    CHECK(target[0] == doctest::Approx(4.0 * 20.0 / 100.0));
}

TEST_CASE("Below the ground there is nothing") {
    MemoryDataset dataset({2, 1, 10}, [](int x, int, int z) {
        return (x == 0 ? 0.0f : 1000.0f) + 100.0f * static_cast<float>(z);
    });
    dataset.addRatio(Species::cloud, [](int, int, int) { return 1e-3f; });
    const SpeciesVolume volume = resample(dataset, 0);
    const Array3f& cloud = volume.content(Species::cloud);
    for (int k = 0; k < volume.grid.size.z; ++k) {
        const double top = volume.grid.originM.z + volume.grid.spacingM.z * (k + 1);
        if (top <= 1000.0 + 1e-6) CHECK(cloud.at(1, 0, k) == 0.0f);
        if (top > 1001.0 && top < 1999.0) CHECK(cloud.at(1, 0, k) > 0.0f);
        if (top > 2000.0 + volume.grid.spacingM.z) CHECK(cloud.at(0, 0, k) == 0.0f);
    }
}

TEST_CASE("The chosen grid covers all layers and is no coarser than the median of them") {
    MemoryDataset dataset({9, 8, 24}, hillHeight);
    const RegularGrid grid = planRead(dataset, 0).grid;
    const double median = medianLayerDepth(readInterfaceHeights(dataset, 0));
    CHECK(grid.size.x == 9);
    CHECK(grid.size.y == 8);
    CHECK(grid.spacingM.x == 500.0);
    CHECK(grid.spacingM.y == 250.0);
    CHECK(grid.spacingM.z <= median);
    CHECK(grid.spacingM.z > 0.9 * median);
    CHECK(grid.originM.z <= 300.0);
    CHECK(grid.upperM().z >= 12000.0 - 1e-6);
    CHECK(grid.upperM().z < 12000.0 + grid.spacingM.z);
    CHECK(grid.size.z <= 256);
}

TEST_CASE("The median of 100 m layers is 100 m, whatever the others are") {
    MemoryDataset dataset({3, 3, 5}, [](int, int, int z) {
        const std::array<float, 6> heights{0.0f, 10.0f, 110.0f, 210.0f, 310.0f, 900.0f};
        return heights[static_cast<std::size_t>(z)];
    });
    CHECK(medianLayerDepth(readInterfaceHeights(dataset, 0)) == doctest::Approx(100.0));
}

TEST_CASE("Levels can be set, and what is chosen stays within its bound") {
    MemoryDataset dataset({2, 2, 400},
                          [](int, int, int z) { return 10.0f * static_cast<float>(z); });
    dataset.addRatio(Species::rain, [](int, int, int) { return 1e-3f; });
    CHECK(resample(dataset, 0).grid.size.z <= 256);
    const SpeciesVolume set = resample(dataset, 0, {withLevels(dataset, 33)});
    CHECK(set.grid.size.z == 33);
    CHECK(targetColumn(set, Species::rain, 1, 1) ==
          doctest::Approx(nativeColumn(dataset, "Q_rain", 1, 1)).epsilon(1e-6));
}

TEST_CASE("Slightly moving levels do not change the grid between the times of a series") {
    RegularGrid first;
    for (const float wobble : {0.0f, 0.3f, -0.3f, 0.8f}) {
        MemoryDataset dataset({3, 3, 60}, [wobble](int, int, int z) {
            return (333.0f + wobble) * static_cast<float>(z);
        });
        const RegularGrid grid = planRead(dataset, 0).grid;
        if (wobble == 0.0f) first = grid;
        CHECK(grid.spacingM.z == first.spacingM.z);
        CHECK(grid.originM == first.originM);
    }
}

TEST_CASE("Absent species are absent, species that are zero are there and noted") {
    MemoryDataset dataset({2, 2, 4},
                          [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    dataset.addRatio(Species::cloud, [](int, int, int) { return 1e-3f; });
    dataset.addRatio(Species::snow, [](int, int, int) { return 0.0f; });
    const SpeciesVolume volume = resample(dataset, 0);
    CHECK(volume.has(Species::cloud));
    CHECK(volume.has(Species::snow));
    CHECK(!volume.has(Species::ice));
    CHECK(volume.notes ==
          std::vector<std::string>{"2024-05-06_21:00:00: Q_snow: zero everywhere at this time."});
    CHECK(volume.timeLabel == "2024-05-06_21:00:00");
}

TEST_CASE("A dataset without density, or with a field off its grid, is an error") {
    const auto height = [](int, int, int z) { return 100.0f * static_cast<float>(z); };
    MemoryDataset dataset({2, 2, 4}, height);
    dataset.add("odd", VariableRole::mixingRatio, Species::hail, {2, 2, 3},
                [](int, int, int) { return 0.0f; });
    CHECK_THROWS_AS(resample(dataset, 0), Error);
}

TEST_CASE("Resampling can be cancelled") {
    MemoryDataset dataset({2, 2, 4},
                          [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    dataset.addRatio(Species::cloud, [](int, int, int) { return 1e-3f; });
    CHECK_THROWS_AS(resample(dataset, 0, {}, [](double) { return false; }), Cancelled);
    double last = 0.0;
    resample(dataset, 0, {}, [&](double fraction) {
        CHECK(fraction >= last);
        CHECK(fraction <= 1.0);
        last = fraction;
        return true;
    });
    CHECK(last > 0.5);
}

TEST_CASE(
    "A species sized by the model is held as extinction, made on native cells and then averaged") {
    // Two columns in a block, one empty: extinction follows from the content of each, not of both.
    MemoryDataset dataset({2, 1, 4},
                          [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    dataset.addRatio(Species::rain, [](int x, int, int) { return x == 0 ? 1e-3f : 0.0f; });
    dataset.addRatio(Species::cloud, [](int, int, int) { return 1e-3f; });
    Look look;
    look.of(Species::rain).radiusSource = RadiusSource::scheme;
    const RadiusPlan radii = planRadii(look, dataset.Dataset::info());
    ReadPlan plan = planRead(dataset, 0);
    plan.coarsening = 2;
    plan.grid.size.x = 1;
    plan.grid.spacingM.x *= 2.0;
    plan.grid.spacingM.y *= 2.0;
    const SpeciesVolume volume = resample(dataset, 0, {plan, radii});
    CHECK(volume.holding(Species::rain) == Holding::extinction);
    CHECK(volume.content(Species::rain).empty());
    CHECK(volume.holding(Species::cloud) == Holding::content);
    // π N0 / λ³ with λ = (π ρ N0 / content)^(1/4), N0 = 8e6, ρ = 1000; one of four columns of the
    // block, of which two lie beyond the border.
    double native = 0.0;
    for (int z = 0; z < 4; ++z) {
        const double content = 1e-3 * 1.2 * std::exp(-(50.0 + 100.0 * z) / 7200.0);
        native += std::numbers::pi * 8e6 / std::pow(std::numbers::pi * 8e9 / content, 0.75) * 100.0;
    }
    double held = 0.0;
    for (const float value : volume.extinction(Species::rain).values) {
        held += static_cast<double>(value) * volume.grid.spacingM.z;
    }
    CHECK(held == doctest::Approx(native / 4.0).epsilon(1e-4));
    CHECK(std::ranges::any_of(volume.notes, [](const std::string& note) {
        return note.starts_with("Rain: the file has no known microphysics scheme");
    }));
}

TEST_CASE("A profile of temperature sizes particles as the same temperature in every column does") {
    const auto extinction = [](glm::ivec3 temperatureSize) {
        MemoryDataset dataset({3, 5, 4},
                              [](int, int, int z) { return 100.0f * static_cast<float>(z); });
        dataset.addRatio(Species::snow,
                         [](int x, int y, int) { return 1e-4f * static_cast<float>(1 + x + y); });
        dataset.add("t", VariableRole::airTemperature, {}, temperatureSize,
                    [](int, int, int z) { return 270.0f - 10.0f * static_cast<float>(z); });
        RadiusPlan radii;
        RadiusRule& rule = radii.rules[static_cast<std::size_t>(Species::snow)];
        rule.source = RadiusSource::scheme;
        rule.scheme = Microphysics::wsm6;
        rule.temperatureVariable = "t";
        return resample(dataset, 0, {{}, radii}).extinction(Species::snow).values;
    };
    const std::vector<float> profile = extinction({1, 1, 4});
    CHECK(profile == extinction({3, 5, 4}));
    CHECK(std::ranges::any_of(profile, [](float value) { return value > 0.0f; }));
}

TEST_CASE("Where rows are stored together, all bands are read through one handle") {
    const auto height = [](int, int, int z) { return 100.0f * static_cast<float>(z); };
    const auto ratio = [](int x, int y, int z) {
        return 1e-6f * static_cast<float>(1 + (x + 3 * y + 7 * z) % 11);
    };
    MemoryDataset apart({512, 64, 40}, height);
    apart.addRatio(Species::cloud, ratio);
    MemoryDataset together = apart;
    together.stated().rowsTogether = 27;
    const auto bands = static_cast<int>(bandsOf(wholeBox(apart.info()), 1).size());
    REQUIRE(bands > 4);
    const SpeciesVolume expected = resample(apart, 0);
    const SpeciesVolume found = resample(together, 0);
    CHECK(together.reads("Q_cloud") == bands);
    const std::size_t cloud = static_cast<std::size_t>(Species::cloud);
    CHECK(found.contentKgPerM3[cloud].values == expected.contentKgPerM3[cloud].values);
    CHECK(found.extinctionPerM[cloud].values == expected.extinctionPerM[cloud].values);
}
