// read_plan_test.cpp: a plan fits its budget, keeps mass, and reads what the region touches.
#include "core/volume/read_plan.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "core/base/error.h"
#include "core/volume/resample.h"
#include "tests/core/memory_dataset.h"
#include "tests/text.h"

using namespace neph;

namespace {

constexpr glm::ivec3 kSize{23, 17, 12};

/// 23 x 17 columns of 500 x 250 m over a slope; cloud and rain that differ in every cell.
MemoryDataset storm() {
    MemoryDataset dataset(kSize, [](int x, int y, int z) {
        const float ground = 10.0f * static_cast<float>(x) + 3.0f * static_cast<float>(y % 5);
        return ground + (6000.0f - ground) * static_cast<float>(z * (z + 6)) / (12.0f * 18.0f);
    });
    dataset.addRatio(Species::cloud, [](int x, int y, int z) {
        return z < 8 ? 1e-4f * static_cast<float>((x * 31 + y * 17 + z * 7) % 13) : 0.0f;
    });
    dataset.addRatio(Species::rain, [](int x, int y, int z) {
        return x > 4 ? 1e-5f * static_cast<float>((x * 5 + y * 3 + z * 11) % 29) : 0.0f;
    });
    return dataset;
}

/// kg of a species in the native columns of `box`.
double nativeMass(Dataset& dataset, const std::string& ratio, const CellBox& box) {
    const Array3f z = dataset.read("z", 0), rho = dataset.read("rho", 0),
                  q = dataset.read(ratio, 0);
    double mass = 0.0;
    for (int k = 0; k < q.size.z; ++k) {
        for (int y = box.lower.y; y < box.upper.y; ++y) {
            for (int x = box.lower.x; x < box.upper.x; ++x) {
                mass += static_cast<double>(q.at(x, y, k)) * static_cast<double>(rho.at(x, y, k)) *
                        static_cast<double>(z.at(x, y, k + 1) - z.at(x, y, k));
            }
        }
    }
    return mass * dataset.info().spacingM.x * dataset.info().spacingM.y;
}

double massOf(const SpeciesVolume& volume, Species species) {
    double sum = 0.0;
    for (const float value : volume.content(species).values) sum += static_cast<double>(value);
    const glm::dvec3 cell = volume.grid.spacingM;
    return sum * cell.x * cell.y * cell.z;
}

ReadPlan coarsenedBy(Dataset& dataset, int coarsening) {
    // The GPU takes 4 bytes per species and 16 of the medium a voxel: 24 here.
    const ReadPlan full = planRead(dataset, 0);
    const auto columns = [](int n, int c) { return static_cast<std::uint64_t>((n + c - 1) / c); };
    return planRead(dataset, 0, {},
                    {.gpu = columns(kSize.x, coarsening) * columns(kSize.y, coarsening) *
                            static_cast<std::uint64_t>(full.grid.size.z) * 24});
}

}  // namespace

TEST_CASE("Without a bound everything is read at full resolution, and nothing is said") {
    MemoryDataset dataset = storm();
    const ReadPlan plan = planRead(dataset, 0);
    CHECK(plan.box == CellBox{{0, 0, 0}, kSize});
    CHECK(plan.coarsening == 1);
    CHECK(plan.grid.size.x == 23);
    CHECK(plan.machineBytes == plan.grid.cellCount() * 8);
    CHECK(plan.gpuBytes == plan.grid.cellCount() * 24);
    CHECK(describe(plan, dataset.info()).empty());
}

TEST_CASE("The finest plan that fits is taken, and says what it averages and what that saves") {
    MemoryDataset dataset = storm();
    for (const int coarsening : {2, 3, 5, 23}) {
        CAPTURE(coarsening);
        const ReadPlan plan = coarsenedBy(dataset, coarsening);
        CHECK(plan.coarsening == coarsening);
        CHECK(plan.grid.spacingM.x == 500.0 * coarsening);
        CHECK(plan.grid.spacingM.y == 250.0 * coarsening);
        CHECK(contains(describe(plan, dataset.info()),
                       fmt::format("Every {0} x {0} columns are averaged", coarsening)));
    }
    // The machine's memory binds as well: 8 bytes per voxel.
    const ReadPlan full = planRead(dataset, 0);
    CHECK(planRead(dataset, 0, {}, {.machine = full.machineBytes - 1}).coarsening == 2);
    CHECK(planRead(dataset, 0, {}, {.machine = full.machineBytes}).coarsening == 1);
}

TEST_CASE("Averaged columns keep the mass of the domain, though no block fits it") {
    MemoryDataset dataset = storm();
    for (const int coarsening : {1, 2, 3, 5, 23}) {
        CAPTURE(coarsening);
        const SpeciesVolume volume = resample(dataset, 0, {coarsenedBy(dataset, coarsening)});
        CHECK(massOf(volume, Species::cloud) ==
              doctest::Approx(nativeMass(dataset, "Q_cloud", {{0, 0, 0}, kSize})).epsilon(1e-6));
        CHECK(massOf(volume, Species::rain) ==
              doctest::Approx(nativeMass(dataset, "Q_rain", {{0, 0, 0}, kSize})).epsilon(1e-6));
    }
}

TEST_CASE("A block of like columns is one of them") {
    MemoryDataset dataset({6, 4, 9},
                          [](int, int, int z) { return 100.0f * static_cast<float>(z * z); });
    dataset.addRatio(Species::snow,
                     [](int, int, int z) { return 1e-4f * static_cast<float>(z % 4); });
    const ReadPlan full = planRead(dataset, 0);
    const SpeciesVolume fine = resample(dataset, 0, {full});
    const SpeciesVolume coarse =
        resample(dataset, 0, {planRead(dataset, 0, {}, {.machine = full.machineBytes / 4})});
    REQUIRE(coarse.grid.size == glm::ivec3(3, 2, fine.grid.size.z));
    for (int k = 0; k < fine.grid.size.z; ++k) {
        CHECK(coarse.content(Species::snow).at(1, 1, k) ==
              doctest::Approx(fine.content(Species::snow).at(2, 2, k)).epsilon(1e-6));
    }
}

TEST_CASE("A region gives the cells that it touches, as they are in the whole") {
    MemoryDataset dataset = storm();
    const BoxM region{{2600.0, 1000.0, 1500.0}, {5100.0, 2250.0, 3000.0}};
    const ReadPlan plan = planRead(dataset, 0, region);
    CHECK(plan.box == CellBox{{5, 4, 0}, {11, 9, kSize.z}});
    CHECK(plan.grid.originM.x == 2500.0);
    CHECK(plan.grid.originM.y == 1000.0);
    CHECK(plan.grid.originM.z <= 1500.0);
    CHECK(plan.grid.originM.z > 1500.0 - plan.grid.spacingM.z);
    CHECK(plan.grid.upperM().z >= 3000.0);
    CHECK(contains(describe(plan, dataset.info()), "x 2.5 to 5.5 km, y 1 to 2.25 km"));

    const SpeciesVolume whole = resample(dataset, 0);
    const SpeciesVolume part = resample(dataset, 0, {plan});
    const auto below = static_cast<int>(
        std::lround((plan.grid.originM.z - whole.grid.originM.z) / plan.grid.spacingM.z));
    for (int k = 0; k < part.grid.size.z; ++k) {
        for (int y = 0; y < part.grid.size.y; ++y) {
            for (int x = 0; x < part.grid.size.x; ++x) {
                CHECK(part.content(Species::cloud).at(x, y, k) ==
                      whole.content(Species::cloud).at(x + 5, y + 4, k + below));
            }
        }
    }
}

TEST_CASE("A region outside the domain is an error that tells where the domain is") {
    MemoryDataset dataset = storm();
    for (const BoxM& region : {BoxM{{20'000.0, 0.0, 0.0}, {30'000.0, 1000.0, 5000.0}},
                               BoxM{{0.0, 0.0, 9000.0}, {5000.0, 1000.0, 12'000.0}},
                               BoxM{{3000.0, 0.0, 0.0}, {2000.0, 1000.0, 5000.0}}}) {
        try {
            planRead(dataset, 0, region);
            FAIL("no error");
        } catch (const Error& error) {
            CHECK(contains(error.parts().expected, "11.5 km"));
            CHECK(contains(error.parts().what, "no cell"));
        }
    }
}

TEST_CASE("Profiles of height and density do for every column") {
    MemoryDataset full(kSize, [](int, int, int z) { return 150.0f * static_cast<float>(z * z); });
    MemoryDataset flat = full.withProfiles();
    for (MemoryDataset* dataset : {&full, &flat}) {
        dataset->addRatio(Species::cloud, [](int x, int y, int z) {
            return 1e-5f * static_cast<float>((x + 2 * y + 3 * z) % 7);
        });
    }
    CHECK(planRead(flat, 0) == planRead(full, 0));
    for (const int coarsening : {1, 4}) {
        const MemoryBudget budget{.machine = planRead(full, 0).machineBytes /
                                             static_cast<unsigned>(coarsening)};
        const ReadPlan plan = planRead(full, 0, {}, budget);
        CHECK(resample(flat, 0, {plan}).content(Species::cloud).values ==
              resample(full, 0, {plan}).content(Species::cloud).values);
    }
}
