// stretched_test.cpp: cells of different widths are remapped to even ones, and nothing is lost.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "core/volume/blocks.h"
#include "core/volume/resample.h"
#include "core/volume/statistics.h"
#include "tests/core/memory_dataset.h"
#include "tests/text.h"

using namespace neph;

namespace {

/// Faces of cells of these widths.
std::vector<double> facesOf(const std::vector<double>& widths) {
    std::vector<double> faces{0.0};
    for (const double width : widths) faces.push_back(faces.back() + width);
    return faces;
}

const std::vector<double> kWide{900.0, 410.0, 250.0, 250.0, 250.0, 333.0, 700.0, 1207.0};
const std::vector<double> kTall{800.0, 300.0, 200.0, 200.0, 640.0, 1000.0};

/// A cloud that differs in every cell, over a slope.
MemoryDataset stretchedStorm() {
    MemoryDataset dataset({8, 6, 10}, [](int x, int y, int z) {
        return 20.0f * static_cast<float>(x + y) + 300.0f * static_cast<float>(z);
    });
    dataset.addRatio(Species::cloud, [](int x, int y, int z) {
        return 1e-4f * static_cast<float>((x * 31 + y * 17 + z * 7) % 13);
    });
    dataset.stretch(facesOf(kWide), facesOf(kTall));
    return dataset;
}

/// kg of cloud, of every native cell times its own area.
double nativeKg(Dataset& dataset) {
    const Array3f z = dataset.read("z", 0), rho = dataset.read("rho", 0),
                  q = dataset.read("Q_cloud", 0);
    double mass = 0.0;
    for (int k = 0; k < q.size.z; ++k) {
        for (int y = 0; y < q.size.y; ++y) {
            for (int x = 0; x < q.size.x; ++x) {
                const double area =
                    kWide[static_cast<std::size_t>(x)] * kTall[static_cast<std::size_t>(y)];
                mass += area * static_cast<double>(q.at(x, y, k)) *
                        static_cast<double>(rho.at(x, y, k)) *
                        static_cast<double>(z.at(x, y, k + 1) - z.at(x, y, k));
            }
        }
    }
    return mass;
}

double heldKg(const SpeciesVolume& volume) {
    double sum = 0.0;
    for (const float value : volume.content(Species::cloud).values) {
        sum += static_cast<double>(value);
    }
    const glm::dvec3 cell = volume.grid.spacingM;
    return sum * cell.x * cell.y * cell.z;
}

}  // namespace

TEST_CASE("Stretched cells become even ones of the smallest width over the same domain") {
    MemoryDataset dataset = stretchedStorm();
    const ReadPlan plan = planRead(dataset, 0);
    // 4300 m of 250 m and 3140 m of 200 m; the last are cut by the border.
    CHECK(plan.grid.size.x == 18);
    CHECK(plan.grid.size.y == 16);
    CHECK(plan.grid.spacingM.x == 250.0);
    CHECK(plan.grid.spacingM.y == 200.0);
    CHECK(plan.grid.originM.x == 0.0);
    CHECK(plan.box == CellBox{{0, 0, 0}, {8, 6, 10}});
    CHECK(describe(plan, dataset.info()) ==
          "Cells of 250 m to 1.21 km x 200 m to 1 km become even ones of 250 m x 200 m.");
}

TEST_CASE("The mass of the domain survives the remapping of stretched cells, and averaging too") {
    MemoryDataset dataset = stretchedStorm();
    const double native = nativeKg(dataset);
    for (const std::uint64_t part : {1U, 4U, 9U, 60U}) {
        const std::uint64_t bytes = planRead(dataset, 0).machineBytes / part;
        const ReadPlan plan = planRead(dataset, 0, {}, {.machine = bytes});
        CAPTURE(plan.coarsening);
        CHECK((part == 1 || plan.coarsening > 1));
        CHECK(heldKg(resample(dataset, 0, {plan})) == doctest::Approx(native).epsilon(1e-6));
    }
}

TEST_CASE("An even grid that is stated by its faces gives what the even grid gives") {
    const auto cloud = [](int x, int y, int z) {
        return 1e-4f * static_cast<float>((x * 5 + y * 3 + z) % 7);
    };
    const auto height = [](int x, int y, int z) {
        return static_cast<float>(10 * x + 7 * y) + 200.0f * static_cast<float>(z);
    };
    MemoryDataset even({6, 5, 8}, height), stated({6, 5, 8}, height);
    even.addRatio(Species::cloud, cloud);
    stated.addRatio(Species::cloud, cloud);
    stated.stretch(facesOf(std::vector<double>(6, 500.0)), facesOf(std::vector<double>(5, 250.0)));
    for (const std::uint64_t part : {1U, 4U}) {
        const MemoryBudget budget{.machine = planRead(even, 0).machineBytes / part};
        const SpeciesVolume a = resample(even, 0, {planRead(even, 0, {}, budget)});
        const SpeciesVolume b = resample(stated, 0, {planRead(stated, 0, {}, budget)});
        REQUIRE(a.grid.size == b.grid.size);
        const std::vector<float>& x = a.content(Species::cloud).values;
        const std::vector<float>& y = b.content(Species::cloud).values;
        for (std::size_t i = 0; i < x.size(); ++i) CHECK(y[i] == doctest::Approx(x[i]));
    }
}

TEST_CASE("A region of stretched cells gives the even cells that it touches, as in the whole") {
    MemoryDataset dataset = stretchedStorm();
    const BoxM region{{1000.0, 900.0, 0.0}, {2000.0, 1700.0, 5000.0}};
    const ReadPlan plan = planRead(dataset, 0, region);
    CHECK(plan.grid.originM.x == 1000.0);
    CHECK(plan.grid.originM.y == 800.0);
    CHECK(plan.grid.size.x == 4);
    CHECK(plan.grid.size.y == 5);
    // x 1000 to 2000 m lies in cells 1 to 4, y 800 to 1800 m in cells 1 to 4.
    CHECK(plan.box == CellBox{{1, 1, 0}, {5, 5, 10}});
    CHECK(contains(describe(plan, dataset.info()), "x 1 to 2 km, y 0.8 to 1.8 km"));
    const SpeciesVolume whole = resample(dataset, 0), part = resample(dataset, 0, {plan});
    const auto below = static_cast<int>(
        std::lround((plan.grid.originM.z - whole.grid.originM.z) / plan.grid.spacingM.z));
    for (int k = 0; k < part.grid.size.z; ++k) {
        for (int y = 0; y < part.grid.size.y; ++y) {
            for (int x = 0; x < part.grid.size.x; ++x) {
                CHECK(part.content(Species::cloud).at(x, y, k) ==
                      doctest::Approx(whole.content(Species::cloud).at(x + 4, y + 4, k + below)));
            }
        }
    }
}

TEST_CASE("Bands of a stretched grid cover every target row once, and own every native row once") {
    // 4000 rows of columns of 64 levels do not fit into one band.
    MemoryDataset dataset({2, 3, 4},
                          [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    DatasetInfo& info = dataset.stated();
    info.size = {400, 300, 64};
    std::vector<double> x(400, 100.0), y;
    for (int j = 0; j < 300; ++j) y.push_back(100.0 + 2.5 * std::abs(j - 150));
    dataset.stretch(facesOf(x), facesOf(y));
    ReadPlan plan;
    plan.box = {{0, 0, 0}, info.size};
    plan.grid.spacingM = {100.0, 100.0, 100.0};
    plan.grid.size = {400, static_cast<int>(std::ceil(info.extentM().y / 100.0)), 64};
    const std::vector<TargetBand> bands = targetBands(plan, info);
    CHECK(bands.size() > 5);
    int row = 0, native = 0;
    for (const TargetBand& band : bands) {
        CHECK(band.firstRow == row);
        CHECK(band.native.lower.y + band.ownRow == native);
        row += band.rows;
        native = band.native.upper.y;
        CHECK(band.native.size().x == 400);
    }
    CHECK(row == plan.grid.size.y);
    CHECK(native == 300);
}

TEST_CASE("Values in rows that two bands of a stretched grid read are corrected and counted once") {
    MemoryDataset dataset({300, 40, 64},
                          [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    dataset.addRatio(Species::rain,
                     [](int x, int, int z) { return x == 7 && z == 3 ? -1e-9f : 1e-4f; });
    std::vector<double> y;
    for (int j = 0; j < 40; ++j) y.push_back(j == 20 ? 250.0 : 330.0);
    dataset.stretch(facesOf(std::vector<double>(300, 250.0)), facesOf(y));
    REQUIRE(targetBands(planRead(dataset, 0), dataset.Dataset::info()).size() > 1);
    const SpeciesVolume volume = resample(dataset, 0);
    REQUIRE(volume.notes.size() == 1);
    CHECK(contains(volume.notes[0], "40 negative values"));
}

TEST_CASE("Positions on a stretched grid are the middles of its cells") {
    MemoryDataset dataset = stretchedStorm();
    dataset.addRatio(Species::hail,
                     [](int x, int y, int z) { return x == 6 && y == 1 && z == 2 ? 2e-3f : 0.0f; });
    const TimeSummary summary = summarise(dataset, 0);
    REQUIRE(summary.peaks.size() == 2);
    // x: 900 + 410 + 3 · 250 + 333 + 700 / 2; y: 800 + 300 / 2.
    CHECK(summary.peaks[1].positionM.x == doctest::Approx(2743.0));
    CHECK(summary.peaks[1].positionM.y == doctest::Approx(950.0));
    CHECK(summary.peaks[1].column.positionM.x == doctest::Approx(2743.0));
}
