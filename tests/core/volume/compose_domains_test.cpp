// compose_domains_test.cpp: volumes of several domains on one grid, and data sets with nests.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/dataset/nested_dataset.h"
#include "core/volume/compose_domains.h"
#include "core/volume/nested_volume.h"
#include "core/volume/resample.h"
#include "tests/core/memory_dataset.h"

using namespace neph;

namespace {

constexpr auto kCloud = static_cast<std::size_t>(Species::cloud);

/// A volume of `cellM` with cloud by a function of the position.
template <typename Value>
SpeciesVolume made(glm::ivec2 cells, double cellM, Value value) {
    SpeciesVolume volume;
    volume.grid.size = {cells, 2};
    volume.grid.spacingM = {cellM, cellM, 100.0};
    Array3f& field = volume.contentKgPerM3[kCloud] = Array3f(volume.grid.size);
    for (int z = 0; z < 2; ++z) {
        for (int y = 0; y < cells.y; ++y) {
            for (int x = 0; x < cells.x; ++x) field.at(x, y, z) = value(x, y);
        }
    }
    return volume;
}

SpeciesVolume empty(glm::ivec2 cells, double cellM) {
    SpeciesVolume volume;
    volume.grid.size = {cells, 2};
    volume.grid.spacingM = {cellM, cellM, 100.0};
    return volume;
}

/// Sum over cells [lower, upper) of the lowest level, times the area of a cell.
double massOf(const SpeciesVolume& volume, glm::ivec2 lower, glm::ivec2 upper) {
    double sum = 0.0;
    for (int y = lower.y; y < upper.y; ++y) {
        for (int x = lower.x; x < upper.x; ++x) {
            sum += static_cast<double>(volume.content(Species::cloud).at(x, y, 0));
        }
    }
    return sum * volume.grid.spacingM.x * volume.grid.spacingM.y;
}
double massOf(const SpeciesVolume& volume) {
    return massOf(volume, {0, 0}, glm::ivec2(volume.grid.size));
}

/// Towers and gaps, as convection has them.
float rough(int x, int y) {
    return (x * 7 + y * 13) % 5 == 0 ? 1e-3f * static_cast<float>(1 + (x + 3 * y) % 4) : 0.0f;
}

const auto kOnes = [](int, int) { return 1e-3f; };

float at(const SpeciesVolume& volume, int x, int y) {
    return volume.content(Species::cloud).at(x, y, 0);
}

/// A domain in memory, with numbers of a nested run, terrain of `groundM` and layers of `layerM`.
std::shared_ptr<MemoryDataset> domain(NestNumbers numbers, glm::ivec3 size, double spacingM,
                                      float groundM, float layerM) {
    auto made = std::make_shared<MemoryDataset>(size, [=](int x, int, int z) {
        return groundM + 3.0f * static_cast<float>(x) + layerM * static_cast<float>(z);
    });
    made->stated().spacingM = {spacingM, spacingM};
    made->stated().nest = numbers;
    return made;
}

}  // namespace

TEST_CASE("A domain alone keeps its mass on any lattice, finer and coarser") {
    const SpeciesVolume outer = made({14, 11}, 3000.0, rough);
    for (const int cell : {1, 2, 3, 4, 6, 7, 9}) {
        CAPTURE(cell);
        const glm::ivec2 cells = (glm::ivec2(14, 11) * 3 + cell - 1) / cell;
        SpeciesVolume result = empty(cells, 1000.0 * cell);
        composeDomain(outer, {{0, 0}, 3}, {}, {{0, 0}, cell}, result);
        CHECK(massOf(result) == doctest::Approx(massOf(outer)).epsilon(1e-6));
        const auto& values = result.content(Species::cloud).values;
        const auto range = std::ranges::minmax(values);
        CHECK(range.min >= 0.0f);
        CHECK(range.max <= 4e-3f * 1.00001f);
    }
    // On its own cells it is what it was.
    SpeciesVolume same = empty({14, 11}, 3000.0);
    composeDomain(outer, {{0, 0}, 3}, {}, {{0, 0}, 3}, same);
    CHECK(same.content(Species::cloud) == outer.content(Species::cloud));
}

TEST_CASE("Between the centres of a parent's cells its values are on a straight line") {
    const SpeciesVolume ramp =
        made({14, 11}, 3000.0, [](int x, int y) { return static_cast<float>(x + 20 * y); });
    SpeciesVolume result = empty({42, 33}, 1000.0), middling = empty({21, 17}, 2000.0);
    composeDomain(ramp, {{0, 0}, 3}, {}, {{0, 0}, 1}, result);
    composeDomain(ramp, {{0, 0}, 3}, {}, {{0, 0}, 2}, middling);
    const auto expected = [](double x, double y) { return x / 3.0 - 0.5 + 20.0 * (y / 3.0 - 0.5); };
    for (int y = 2; y < 31; ++y) {
        for (int x = 2; x < 40; ++x) {
            CHECK(at(result, x, y) == doctest::Approx(expected(x + 0.5, y + 0.5)).epsilon(1e-5));
        }
    }
    for (int y = 1; y < 15; ++y) {
        for (int x = 1; x < 20; ++x) {
            CHECK(at(middling, x, y) ==
                  doctest::Approx(expected(2.0 * x + 1.0, 2.0 * y + 1.0)).epsilon(1e-5));
        }
    }
}

TEST_CASE("Constants stay constants, also across the edge of a nest") {
    SpeciesVolume result = empty({42, 33}, 1000.0);
    composeDomain(made({14, 11}, 3000.0, kOnes), {{0, 0}, 3}, {}, {{0, 0}, 1}, result);
    composeDomain(made({18, 15}, 1000.0, kOnes), {{9, 6}, 1}, NestEdges{{9, 6}, {27, 21}, 5.0},
                  {{0, 0}, 1}, result);
    for (const float value : result.content(Species::cloud).values) {
        CHECK(value == doctest::Approx(1e-3f).epsilon(1e-6));
    }
}

TEST_CASE("Mass outside is the parent's and inside the nest's, and the nest's cells are its own") {
    const SpeciesVolume outer = made({14, 11}, 3000.0, rough);
    const SpeciesVolume inner =
        made({21, 18}, 1000.0, [](int x, int y) { return rough(y, x + 1); });
    SpeciesVolume result = empty({42, 33}, 1000.0), alone = empty({42, 33}, 1000.0);
    const NestEdges edges{{9, 6}, {30, 24}, 5.0};
    composeDomain(outer, {{0, 0}, 3}, {}, {{0, 0}, 1}, alone);
    composeDomain(outer, {{0, 0}, 3}, {}, {{0, 0}, 1}, result);
    composeDomain(inner, {{9, 6}, 1}, edges, {{0, 0}, 1}, result);
    const double nested = massOf(result, {9, 6}, {30, 24});
    CHECK(massOf(result) - nested ==
          doctest::Approx(massOf(alone) - massOf(alone, {9, 6}, {30, 24})).epsilon(1e-6));
    CHECK(massOf(result, {14, 11}, {25, 19}) ==
          doctest::Approx(massOf(inner, {5, 5}, {16, 13})).epsilon(1e-6));
    CHECK(at(result, 14, 11) == at(inner, 5, 5));
    CHECK(at(result, 24, 18) == at(inner, 15, 12));
}

TEST_CASE("The nest's weight grows without a step from its edge, and has its place at corners") {
    const NestEdges edges{{10, 20}, {40, 60}, 5.0};
    CHECK(nestWeight(edges, {10.0, 40.0}) == 0.0);
    CHECK(nestWeight(edges, {9.0, 40.0}) == 0.0);
    CHECK(nestWeight(edges, {12.5, 40.0}) == doctest::Approx(0.5));
    CHECK(nestWeight(edges, {15.0, 40.0}) == 1.0);
    CHECK(nestWeight(edges, {39.0, 22.5}) == nestWeight(edges, {39.0, 40.0}));
    double before = 0.0;
    for (double x = 10.0; x <= 15.0; x += 0.125) {
        const double weight = nestWeight(edges, {x, 40.0});
        CHECK(weight >= before);
        CHECK(weight - before < 0.04);  // 1.5 / 5 per cell is the steepest
        before = weight;
    }
    SpeciesVolume result = empty({30, 30}, 1000.0);
    composeDomain(made({10, 10}, 3000.0, [](int, int) { return 0.0f; }), {{0, 0}, 3}, {},
                  {{0, 0}, 1}, result);
    composeDomain(made({18, 18}, 1000.0, kOnes), {{6, 6}, 1}, NestEdges{{6, 6}, {24, 24}, 5.0},
                  {{0, 0}, 1}, result);
    for (int x = 6; x < 12; ++x) CHECK(at(result, x, 15) >= at(result, x - 1, 15));
    CHECK(at(result, 5, 15) == 0.0f);
    CHECK(at(result, 6, 15) > 0.0f);
    CHECK(at(result, 11, 15) == 1e-3f);
}

TEST_CASE("A nest at the parent's edge, and two beside each other, keep to their own places") {
    const SpeciesVolume outer = made({12, 8}, 3000.0, kOnes);
    SpeciesVolume result = empty({36, 24}, 1000.0);
    composeDomain(outer, {{0, 0}, 3}, {}, {{0, 0}, 1}, result);
    const auto nest = [&](glm::ivec2 corner, float value) {
        composeDomain(made({18, 24}, 1000.0, [=](int, int) { return value; }), {corner, 1},
                      NestEdges{corner, corner + glm::ivec2(18, 24), 5.0}, {{0, 0}, 1}, result);
    };
    nest({0, 0}, 2e-3f);
    nest({18, 0}, 4e-3f);
    CHECK(at(result, 9, 12) == 2e-3f);
    CHECK(at(result, 27, 12) == 4e-3f);
    // At the edges, those of the parent included, the values are the parent's.
    CHECK(at(result, 0, 12) < 1.1e-3f);
    CHECK(at(result, 17, 12) < 1.1e-3f);
    CHECK(at(result, 18, 12) < 1.1e-3f);
}

TEST_CASE("A nest finer or coarser than the result keeps its mass in blocks of result cells") {
    const SpeciesVolume inner = made({36, 36}, 1000.0, rough);
    const NestEdges edges{{0, 0}, {36, 36}, 0.0};  // all of it counts
    for (const int cell : {1, 2, 4, 6}) {
        CAPTURE(cell);
        SpeciesVolume result = empty({36 / cell, 36 / cell}, 1000.0 * cell);
        composeDomain(inner, {{0, 0}, 1}, edges, {{0, 0}, cell}, result);
        CHECK(massOf(result) == doctest::Approx(massOf(inner)).epsilon(1e-6));
    }
    SpeciesVolume fine =
        empty({72, 72}, 500.0);  // a sibling of cells half as wide sets the lattice
    composeDomain(inner, {{0, 0}, 2}, NestEdges{{0, 0}, {72, 72}, 0.0}, {{0, 0}, 1}, fine);
    CHECK(massOf(fine) == doctest::Approx(massOf(inner)).epsilon(1e-6));
}

TEST_CASE("What one domain lacks counts as none of it, extinction like content") {
    SpeciesVolume outer = made({12, 12}, 3000.0, kOnes);
    const auto ice = static_cast<std::size_t>(Species::ice);
    SpeciesVolume inner = empty({18, 18}, 1000.0);
    inner.extinctionPerM[ice] = Array3f(inner.grid.size, 0.02f);
    SpeciesVolume result = empty({36, 36}, 1000.0);
    composeDomain(outer, {{0, 0}, 3}, {}, {{0, 0}, 1}, result);
    composeDomain(inner, {{9, 9}, 1}, NestEdges{{9, 9}, {27, 27}, 5.0}, {{0, 0}, 1}, result);
    CHECK(at(result, 18, 18) == 0.0f);
    CHECK(at(result, 2, 2) == doctest::Approx(1e-3f));
    CHECK(result.extinction(Species::ice).at(18, 18, 0) == 0.02f);
    CHECK(result.extinction(Species::ice).at(2, 2, 0) == 0.0f);
}

TEST_CASE("Domains of other terrain and levels are remapped by their own heights, mass kept") {
    const auto outer = domain({.number = 1}, {12, 10, 20}, 3000.0, 200.0f, 500.0f);
    const auto inner = domain({.number = 2, .parent = 1, .cornerCells = {3, 2}, .ratio = 3},
                              {18, 18, 30}, 1000.0, 350.0f, 300.0f);
    outer->addRatio(Species::cloud,
                    [](int x, int y, int z) { return z > 3 && z < 12 ? rough(x + z, y) : 0.0f; });
    inner->addRatio(Species::cloud,
                    [](int x, int y, int z) { return z > 5 && z < 20 ? rough(x, y + z) : 0.0f; });
    const auto both = nestWithin({outer, 0.0, "d01"}, {{inner, 0.0, "d02"}});
    REQUIRE(both->nests().size() == 1);
    const NestedPlan plan = planNested(*both, 0);
    CHECK(plan.shown.grid.spacingM.z == 300.0);
    const SpeciesVolume volume = readNested(*both, 0, plan, {});
    const auto columnMass = [](const SpeciesVolume& of, glm::ivec2 lower, glm::ivec2 upper) {
        double sum = 0.0;
        for (int z = 0; z < of.grid.size.z; ++z) {
            for (int y = lower.y; y < upper.y; ++y) {
                for (int x = lower.x; x < upper.x; ++x) {
                    sum += static_cast<double>(of.content(Species::cloud).at(x, y, z));
                }
            }
        }
        return sum * of.grid.spacingM.x * of.grid.spacingM.y * of.grid.spacingM.z;
    };
    // Inside, what the nest has by itself.
    const double own = columnMass(resample(*inner, 0), {5, 5}, {13, 13});
    REQUIRE(own > 0.0);
    CHECK(columnMass(volume, {14, 11}, {22, 19}) == doctest::Approx(own).epsilon(1e-3));
    // The parent by itself keeps all of its mass, and is what is seen outside of the nest.
    const SpeciesVolume alone = resample(*outer, 0);
    NestedPlan outside = plan;
    outside.domains.resize(1);
    SpeciesVolume parent;
    parent.grid = plan.shown.grid;
    const SpeciesVolume levels = resample(*outer, 0, {outside.domains[0].plan, {}});
    composeDomain(levels, outside.domains[0].at, {}, plan.at, parent);
    CHECK(columnMass(parent, {0, 0}, {36, 30}) ==
          doctest::Approx(columnMass(alone, {0, 0}, {12, 10})).epsilon(1e-3));
    for (const glm::ivec4 part : {glm::ivec4(0, 0, 9, 30), glm::ivec4(9, 24, 36, 30)}) {
        CHECK(columnMass(volume, {part.x, part.y}, {part.z, part.w}) ==
              doctest::Approx(columnMass(parent, {part.x, part.y}, {part.z, part.w})));
    }
}

TEST_CASE("Memory decides the spacing, which is never finer than the finest nest's") {
    const auto outer = domain({.number = 1}, {12, 10, 20}, 3000.0, 0.0f, 500.0f);
    const auto inner = domain({.number = 2, .parent = 1, .cornerCells = {3, 2}, .ratio = 3},
                              {18, 18, 20}, 1000.0, 0.0f, 500.0f);
    for (const auto& each : {outer, inner}) {
        each->addRatio(Species::cloud, [](int x, int y, int) { return rough(x, y); });
    }
    const auto both = nestWithin({outer, 0.0, "d01"}, {{inner, 0.0, "d02"}});
    const ReadPlan full = planShown(*both, 0);
    CHECK(full.grid.spacingM.x == 1000.0);
    CHECK(full.nested == "d02 (1 km) within d01 (3 km), shown at 1 km.");
    for (const std::uint64_t part : {2U, 5U, 12U, 40U}) {
        CAPTURE(part);
        const MemoryBudget budget{.machine = full.machineBytes / part};
        const NestedPlan plan = planNested(*both, 0, {}, budget);
        CHECK(plan.shown.machineBytes <= budget.machine);
        const SpeciesVolume volume = readNested(*both, 0, plan, {});
        CHECK(volume.grid == plan.shown.grid);
        CHECK(volume.bytes() <= budget.machine);
    }
    CHECK(planShown(*both, 0, {}, {.machine = 1}).grid.size.x == 1);
}

TEST_CASE("Coarser cells of the result are the means of the finer ones, wherever the nest begins") {
    // The corner of the nest is odd on the lattice, and so lies within a cell of the result.
    const auto outer = domain({.number = 1}, {12, 10, 20}, 3000.0, 0.0f, 500.0f);
    const auto inner = domain({.number = 2, .parent = 1, .cornerCells = {3, 1}, .ratio = 3},
                              {24, 24, 20}, 1000.0, 0.0f, 500.0f);
    for (const auto& each : {outer, inner}) {
        each->addRatio(Species::cloud, [](int x, int y, int) { return rough(x, y); });
    }
    const auto both = nestWithin({outer, 0.0, "d01"}, {{inner, 0.0, "d02"}});
    const NestedPlan full = planNested(*both, 0);
    const SpeciesVolume fine = readNested(*both, 0, full, {});
    const NestedPlan half = planNested(*both, 0, {}, {.gpu = full.shown.gpuBytes / 4});
    REQUIRE(half.shown.grid.spacingM.x == 2000.0);
    CHECK(half.shown.coarsening == 2);
    const SpeciesVolume coarse = readNested(*both, 0, half, {});
    for (int y = 5; y < 11; ++y) {
        for (int x = 8; x < 14; ++x) {
            const auto& values = fine.content(Species::cloud);
            float sum = 0.0f;
            for (const glm::ivec2 at : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
                sum += values.at(2 * x + at.x, 2 * y + at.y, 4);
            }
            CHECK(coarse.content(Species::cloud).at(x, y, 4) ==
                  doctest::Approx(0.25f * sum).epsilon(1e-3));
        }
    }
}
