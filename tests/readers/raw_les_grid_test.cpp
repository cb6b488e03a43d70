// raw_les_grid_test.cpp: grids of CM1 that are not even boxes: levels that follow terrain,
// stretched cells, axisymmetric runs.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "core/plugin/reader_file.h"
#include "tests/readers/raw_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

/// What the reader states, before the host makes even cells of it.
DatasetInfo described(const std::filesystem::path& path) {
    return ReaderFile(readerHost().pick(path), path).description();
}

/// A descriptor's line with the middles of cells that have these widths in metres.
std::string axisOf(const char* name, const std::vector<double>& widthsM) {
    std::string line = fmt::format("{} {} levels\n", name, widthsM.size());
    double face = -0.5 * std::accumulate(widthsM.begin(), widthsM.end(), 0.0);
    for (const double width : widthsM) {
        line += fmt::format("  {:.6E}\n", (face + 0.5 * width) / 1000.0);
        face += width;
    }
    return line;
}

/// A hill of 0 to 132 m below a top of 330 m, with heights of cells if `cells`.
GradsSpec hill(bool cells) {
    GradsSpec spec;
    spec.times = 1;
    spec.variables = {"zs 0 99 terrain height (m)", "qc {} 99 qc (kg/kg)"};
    spec.zdef = "zdef 3 levels 0.05 0.155 0.27\n";  // interfaces 0, 100, 210, 330 m
    if (cells) spec.variables.push_back("zhval {} 99 height on model levels (m)");
    spec.value = [](std::size_t v, std::size_t x, std::size_t, std::size_t z, std::size_t) {
        constexpr std::array kNominal{50.0f, 155.0f, 270.0f};
        const float ground = 33.0f * static_cast<float>(x);
        if (v == 0) return ground;
        return v == 1 ? 1e-4f : ground + kNominal[z] * (330.0f - ground) / 330.0f;
    };
    return spec;
}

}  // namespace

TEST_CASE("Levels of CM1 follow the terrain, by the heights of cells or those of the ground") {
    for (const bool cells : {false, true}) {
        CAPTURE(cells);
        const TemporaryFolder folder;
        const auto dataset = openFiles({writeGrads(folder.path(), hill(cells))});
        const Array3f z = dataset->read("interface_height", 0);
        REQUIRE(z.size == glm::ivec3(5, 4, 4));
        // By hand: z = zs + ζ (330 − zs) / 330.
        CHECK(z.at(0, 0, 1) == doctest::Approx(100.0));
        CHECK(z.at(4, 3, 0) == doctest::Approx(132.0));
        CHECK(z.at(4, 3, 1) == doctest::Approx(192.0));
        CHECK(z.at(4, 3, 2) == doctest::Approx(258.0));
        CHECK(z.at(2, 0, 1) == doctest::Approx(146.0));
        CHECK(z.at(2, 0, 3) == doctest::Approx(330.0));
        const Array3f part = dataset->read("interface_height", 0, CellBox{{4, 1, 1}, {5, 2, 3}});
        CHECK(part.values[0] == doctest::Approx(192.0));
        CHECK(part.values[1] == doctest::Approx(258.0));
        // The standard atmosphere at the middle of the cell, by its density formula.
        CHECK(dataset->read("dry_air_density", 0).at(3, 0, 1) ==
              doctest::Approx(1.225 * std::pow(1.0 - 2.25577e-5 * 207.5, 4.2559)).epsilon(1e-4));
        CHECK(hasNote(dataset->info(), "Gal-Chen and Somerville") == !cells);
    }
}

TEST_CASE("Heights of cells without the ground are continued below the lowest") {
    const TemporaryFolder folder;
    GradsSpec spec = hill(true);
    spec.title = "some model; units of x,y,z are km";
    spec.metadata = false;
    spec.variables[0] = "tsk 0 99 skin temperature (K)";
    const Array3f z = openFiles({writeGrads(folder.path(), spec)})->read("interface_height", 0);
    CHECK(z.at(4, 0, 0) == doctest::Approx(132.0));
    CHECK(z.at(4, 0, 1) == doctest::Approx(192.0));
}

TEST_CASE("Flat ground leaves the nominal levels, and the ground of another model says nothing") {
    for (const bool cm1 : {false, true}) {
        const TemporaryFolder folder;
        GradsSpec spec = hill(false);
        if (!cm1) spec.title = "some model; units of x,y,z are km";
        if (cm1) spec.value = [](auto v, auto, auto, auto, auto) { return v == 0 ? 0.0f : 1e-4f; };
        const auto dataset = openFiles({writeGrads(folder.path(), spec)});
        CHECK(dataset->read("interface_height", 0).values == std::vector<float>{0, 100, 210, 330});
        CHECK(hasNote(dataset->info(), "zs, the height of the ground, is not used") == !cm1);
    }
}

TEST_CASE("Terrain without any height in the file is refused with what to write out") {
    const TemporaryFolder folder;
    GradsSpec spec;
    const auto ctl = writeGrads(folder.path(), spec);
    writeText(folder / "namelist.input", " terrain_flag = .true.,\n ptype = 5,\n");
    const ErrorParts error = errorOf([&] { openFiles({ctl}); });
    CHECK(contains(error.what, "follow terrain"));
    CHECK(contains(error.hint, "output_zs = 1"));
    std::filesystem::rename(ctl, folder / "cm1out_i.ctl");
    CHECK(contains(errorOf([&] { openFiles({folder / "cm1out_i.ctl"}); }).hint, "cm1out_s.ctl"));
}

TEST_CASE("Stretched cells are described by their faces, with each centre in the middle") {
    const std::vector<double> widths{400, 300, 200, 100, 100, 100, 100, 200, 300, 400};
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.nx = spec.ny = widths.size();
    spec.xdef = axisOf("xdef", widths);
    spec.ydef = axisOf("ydef", std::vector<double>(10, 125.0));
    const DatasetInfo info = described(writeGrads(folder.path(), spec));
    REQUIRE(info.edgesM[0].size() == 11);
    CHECK(info.edgesM[1].empty());
    CHECK(info.spacingM.x == doctest::Approx(100.0));
    CHECK(info.spacingM.y == doctest::Approx(125.0));
    CHECK(info.edgesM[0][0] == 0.0);
    double face = 0.0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        face += widths[i];
        CHECK(info.edgesM[0][i + 1] == doctest::Approx(face).epsilon(1e-5));
    }
}

TEST_CASE("A grid that stretches everywhere and one that has no middles get positive widths") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.nx = 12;
    spec.ny = 6;
    std::vector<double> widths;
    for (int i = 0; i < 12; ++i) widths.push_back(100.0 * std::pow(1.1, i));
    spec.xdef = axisOf("xdef", widths);
    spec.ydef = "ydef 6 levels 2.1 2.0 1.1 1.0 0.1 0\n";  // decreasing: stored from the north
    const DatasetInfo info = described(writeGrads(folder.path(), spec));
    double face = 0.0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        face += widths[i];
        CHECK(info.edgesM[0][i + 1] == doctest::Approx(face).epsilon(2e-3));
    }
    // Halfway, and half a spacing beyond: -50, 50, 550, 1050, 1550, 2050, 2150 m.
    const std::vector<double> halfway{0, 100, 600, 1100, 1600, 2100, 2200};
    REQUIRE(info.edgesM[1].size() == 7);
    for (std::size_t i = 0; i < 7; ++i) {
        CHECK(info.edgesM[1][i] == doctest::Approx(halfway[i]).epsilon(1e-6));
    }
    spec.xdef = "xdef 12 levels 1 2 3 4 5 6 7 8 9 10 11 11\n";
    CHECK(contains(errorOf([&] { described(writeGrads(folder.path(), spec)); }).what, "xdef"));
}

TEST_CASE("Coordinates that are even up to their printed digits are even") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.nx = 4;
    spec.xdef = "xdef 4 levels 500.0333 500.1000 500.1667 500.2333\n";
    const DatasetInfo info = described(writeGrads(folder.path(), spec));
    CHECK(info.edgesM[0].empty());
    CHECK(info.spacingM.x == doctest::Approx(66.667).epsilon(1e-3));
}

TEST_CASE("An axisymmetric run is revolved around its axis") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.nx = 8;
    spec.ny = 1;
    spec.times = 1;
    spec.xdef = "xdef 8 linear 0.05 0.1\n";
    spec.variables = {"sst 0 99 sst (K)", "th {} 99 th (K)", "prs {} 99 prs (Pa)",
                      "qv {} 99 qv (kg/kg)", "qc {} 99 qc (kg/kg)"};
    spec.value = [](std::size_t v, std::size_t x, std::size_t, std::size_t, std::size_t) {
        constexpr std::array kAir{300.0f, 300.0f, 9e4f, 0.01f};
        return v < 4 ? kAir[v] : 1e-3f * (8.0f - static_cast<float>(x));
    };
    const auto ctl = writeGrads(folder.path(), spec);
    CHECK(contains(described(ctl).notes.back(), "taken as a slab"));
    writeText(folder / "namelist.input", " axisymm = 1,\n ptype = 1,\n");
    const auto dataset = openFiles({ctl});
    CHECK(dataset->info().size == glm::ivec3(16, 16, 3));
    CHECK(dataset->info().spacingM.y == doctest::Approx(100.0));
    const Array3f qc = dataset->read("qc", 0);
    // The middle of cell (12, 8) is at (450, 50) m, radius 452.769 m; q falls by 1e-5 per metre
    // from 8e-3 at 50 m.
    CHECK(qc.at(12, 8, 0) == doctest::Approx(8e-3 - 1e-5 * 402.769).epsilon(1e-5));
    CHECK(qc.at(3, 7, 2) == qc.at(12, 8, 0));
    CHECK(qc.at(8, 12, 1) == qc.at(12, 8, 0));
    CHECK(qc.at(0, 0, 0) == 0.0f);  // 1061 m, outside
    CHECK(dataset->read("prs", 0).at(0, 0, 0) == 9e4f);
    CHECK(dataset->read("dry_air_density", 0).at(0, 15, 2) ==
          dataset->read("dry_air_density", 0).at(8, 8, 0));
    // The mass of a cone that ends at 1e-3 kg/kg on the rim, by its integral: to 2 %.
    const double sum = std::accumulate(qc.values.begin(), qc.values.begin() + 256, 0.0) * 1e4;
    double rings = 0.0;
    for (int i = 0; i < 8; ++i) rings += 1e-3 * (8 - i) * 3.14159265 * 1e4 * (2 * i + 1);
    CHECK(sum == doctest::Approx(rings).epsilon(0.02));
    CHECK(contains(dataset->info().notes.back(), "revolved around the axis"));
}

TEST_CASE("An axisymmetric run with several rows, or that does not start at the axis, is refused") {
    GradsSpec spec;
    const TemporaryFolder folder;
    writeText(folder / "namelist.input", " axisymm = 1,\n");
    CHECK(contains(errorOf([&] { described(writeGrads(folder.path(), spec)); }).what, "one row"));
    spec.ny = 1;
    CHECK(contains(errorOf([&] { described(writeGrads(folder.path(), spec)); }).what,
                   "does not start at the axis"));
}

TEST_CASE("A stretched axisymmetric run has its faces on both sides of the axis") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.nx = 7;
    spec.ny = 1;
    spec.xdef = "xdef 7 levels 0.05 0.15 0.25 0.35 0.475 0.65 0.875\n";
    writeText(folder / "namelist.input", " axisymm = 1,\n");
    const DatasetInfo info = described(writeGrads(folder.path(), spec));
    REQUIRE(info.edgesM[0].size() == 15);
    CHECK(info.edgesM[0] == info.edgesM[1]);
    // 1000 m to either side: 250, 200, 150 and four of 100 m.
    CHECK(info.edgesM[0][1] == doctest::Approx(250.0));
    CHECK(info.edgesM[0][7] == doctest::Approx(1000.0));
    CHECK(info.edgesM[0][8] == doctest::Approx(1100.0));
    CHECK(info.edgesM[0][14] == doctest::Approx(2000.0));
}
