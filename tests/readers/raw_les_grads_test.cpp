// raw_les_grads_test.cpp: GrADS descriptors: every layout of the same numbers reads the same, and
// files that do not fit their descriptor are refused.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <tuple>

#include "tests/readers/raw_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

ErrorParts grammarError(const GradsSpec& spec) {
    const TemporaryFolder folder;
    const auto ctl = writeGrads(folder.path(), spec);
    return errorOf([&] { openFiles({ctl}); });
}

void checkValues(Dataset& dataset, const GradsSpec& spec) {
    for (std::size_t v = 0; v < spec.variables.size(); ++v) {
        const std::string name = spec.variables[v].substr(0, spec.variables[v].find(' '));
        for (std::size_t t = 0; t < spec.times; ++t) {
            const Array3f values = dataset.read(name, static_cast<int>(t));
            std::size_t wrong = 0;
            for (int z = 0; z < values.size.z; ++z) {
                for (int y = 0; y < values.size.y; ++y) {
                    for (int x = 0; x < values.size.x; ++x) {
                        const float expected =
                            gradsValue(v, static_cast<std::size_t>(x), static_cast<std::size_t>(y),
                                       static_cast<std::size_t>(z), t);
                        if (values.at(x, y, z) != expected) ++wrong;
                    }
                }
            }
            CAPTURE(name);
            CHECK(wrong == 0);
        }
    }
}

}  // namespace

TEST_CASE("Every layout of a GrADS file reads the same numbers") {
    for (int flags = 0; flags < 64; ++flags) {
        CAPTURE(flags);
        GradsSpec spec;
        spec.isTemplate = (flags & 1) != 0;
        spec.sequential = (flags & 2) != 0;
        spec.swapped = (flags & 4) != 0;
        spec.yrev = (flags & 8) != 0;
        spec.zrev = (flags & 16) != 0;
        spec.bigEndianOption = (flags & 32) != 0;
        const TemporaryFolder folder;
        const auto dataset = openFiles({writeGrads(folder.path(), spec)});
        checkValues(*dataset, spec);
        const Array3f part = dataset->read("qc", 1, CellBox{{1, 1, 1}, {3, 4, 2}});
        CHECK(part.size == glm::ivec3(2, 3, 1));
        CHECK(part.at(1, 2, 0) == gradsValue(4, 2, 3, 1, 1));
    }
}

TEST_CASE("Levels listed from the top down and a decreasing ydef are reversed") {
    GradsSpec spec;
    spec.zdef = "zdef 3 levels\n0.25\n 0.15 0.05\n";
    spec.zrev = true;  // the top is written first; the descriptor shows it only by its levels
    spec.options = "";
    const TemporaryFolder folder;
    const auto ctl = writeGrads(folder.path(), spec);
    std::ifstream stream(ctl);
    std::string text((std::istreambuf_iterator<char>(stream)), {});
    text.erase(text.find("options"), text.find("title") - text.find("options"));
    const std::string ydef = "linear 0.1 0.2";
    text.replace(text.find(ydef), ydef.size(), "linear 0.7 -0.2");
    writeText(ctl, text);
    const auto dataset = openFiles({ctl});
    CHECK(dataset->read("qc", 0).at(2, 3, 0) == gradsValue(4, 2, 0, 0, 0));
    CHECK(dataset->read("interface_height", 0).values == std::vector<float>{0, 100, 200, 300});
}

TEST_CASE("Grid, times and air of a CM1 descriptor are in SI") {
    const TemporaryFolder folder;
    GradsSpec spec;
    const auto dataset = openFiles({writeGrads(folder.path(), spec)});
    const DatasetInfo& info = dataset->info();
    CHECK(info.model == "CM1 r21.1");
    CHECK(info.size == glm::ivec3(5, 4, 3));
    CHECK(info.spacingM.x == doctest::Approx(100.0));
    CHECK(info.spacingM.y == doctest::Approx(200.0));
    CHECK(info.times[0].label == "540 s");
    CHECK(info.times[1].seconds == 180.0);
    CHECK(dataset->read("interface_height", 0).values == std::vector<float>{0, 100, 200, 300});
    // By hand with CM1's constants: 300 K and 9e4 Pa give 291.1129 K; with 7.8125 g/kg of vapour
    // 9e4 / (287.04 · 291.1129 · 1.0125608) kg/m³.
    CHECK(dataset->read("air_temperature", 0).values[0] ==
          doctest::Approx(291.11291).epsilon(1e-6));
    CHECK(dataset->read("dry_air_density", 0).values[0] ==
          doctest::Approx(1.0636959).epsilon(1e-6));
    CHECK(info.find("rain")->size.z == 1);
    CHECK(info.notes.empty());
}

TEST_CASE("Known units of variables are converted, and unknown ones are errors that list them") {
    GradsSpec spec;
    spec.variables[4] = "qc {} 99 cloud (g/kg)";
    spec.variables.push_back("effc {} 99 radius (micron)");
    spec.variables.push_back("nci {} 99 nci (#/kg)");
    const TemporaryFolder folder;
    const auto dataset = openFiles({writeGrads(folder.path(), spec)});
    CHECK(dataset->read("qc", 0).at(1, 1, 1) ==
          doctest::Approx(static_cast<double>(gradsValue(4, 1, 1, 1, 0)) * 1e-3));
    CHECK(dataset->info().find("qc")->units == "kg kg-1");
    const VariableInfo* radius =
        dataset->info().find(VariableRole::effectiveRadius, Species::cloud);
    REQUIRE(radius != nullptr);
    CHECK(dataset->read(radius->name, 0).at(1, 1, 1) ==
          doctest::Approx(static_cast<double>(gradsValue(5, 1, 1, 1, 0)) * 1e-6));
    CHECK(dataset->info().find(VariableRole::numberConcentration, Species::ice) != nullptr);
    spec.variables[4] = "qc {} 99 cloud";
    CHECK(contains(grammarError(spec).what, "unit of variable qc"));
    CHECK(contains(grammarError(spec).expected, "kg/kg"));
    spec = {};
    spec.title = "CM1 output";
    CHECK(contains(grammarError(spec).what, "unit of xdef"));
    CHECK(contains(grammarError(spec).hint, "units of x,y,z are m"));
}

TEST_CASE("The value of undef becomes missing, also in the other byte order") {
    for (const bool swapped : {false, true}) {
        const TemporaryFolder folder;
        GradsSpec spec;
        spec.swapped = swapped;
        const auto ctl = writeGrads(folder.path(), spec);
        std::vector<float> values(2 * (20 + 4 * 60), 1.0f);
        values[20] = -999999.9f;
        writeFloats(folder / "cm1out_s.dat", values, swapped);
        const Array3f theta = openFiles({ctl})->read("th", 0);
        CHECK(std::isnan(theta.values[0]));
        CHECK(theta.values[1] == 1.0f);
    }
}

TEST_CASE("Data files of any wrong size are errors with the actual and the expected size") {
    for (const bool isTemplate : {false, true}) {
        CAPTURE(isTemplate);
        GradsSpec spec;
        spec.isTemplate = isTemplate;
        const std::string name = isTemplate ? "cm1out_000001_s.dat" : "cm1out_s.dat";
        const std::size_t whole = (isTemplate ? 1 : 2) * (20 + 4 * 60) * 4;
        for (const std::size_t bytes : {whole - 1, whole - 4, whole + 4, std::size_t{0}}) {
            CAPTURE(bytes);
            const TemporaryFolder folder;
            const auto ctl = writeGrads(folder.path(), spec);
            for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
                if (entry.path().string().ends_with("_s.dat")) {
                    writeText(entry.path(), std::string(bytes, 'x'));
                }
            }
            const ErrorParts error = errorOf([&] { openFiles({ctl}); });
            CHECK(contains(error.where, name));
            CHECK(contains(error.what, bytes < whole ? "shorter" : "longer"));
            CHECK(contains(error.found, fmt::format("{} bytes", bytes)));
            CHECK(contains(error.expected, fmt::format("{} bytes", whole)));
        }
    }
}

TEST_CASE("Times that the descriptor of a running model does not count yet are left out") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.times = 3;
    spec.tdef = "tdef 2 linear 00:00Z01JAN0001 1YR\n";
    const auto dataset = openFiles({writeGrads(folder.path(), spec)});
    CHECK(dataset->info().times.size() == 2);
    CHECK(contains(dataset->info().notes.at(0), "contains 3 times, but its descriptor states 2"));
}

TEST_CASE("A time whose file is missing is left out with a note; no file at all is an error") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.isTemplate = true;
    const auto ctl = writeGrads(folder.path(), spec);
    std::filesystem::remove(folder / "cm1out_000001_s.dat");
    const auto dataset = openFiles({ctl});
    REQUIRE(dataset->info().times.size() == 1);
    CHECK(dataset->info().times[0].label == "720 s");
    CHECK(contains(dataset->info().notes.at(0), "cm1out_000001_s.dat"));
    CHECK(dataset->read("qc", 0).at(1, 0, 0) == gradsValue(4, 1, 0, 0, 1));
    std::filesystem::remove(folder / "cm1out_000002_s.dat");
    CHECK(contains(errorOf([&] { openFiles({ctl}); }).what, "data file is missing"));
    writeText(folder / "cm1out_000003_000001_s.dat", "x");
    const ErrorParts error = errorOf([&] { openFiles({ctl}); });
    CHECK(contains(error.what, "MPI rank"));
    CHECK(contains(error.found, "cm1out_000003_000001_s.dat"));
}

TEST_CASE("Wrong record lengths of sequential files are detected on opening") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.sequential = true;
    const auto ctl = writeGrads(folder.path(), spec);
    const auto bytes = std::filesystem::file_size(folder / "cm1out_s.dat");
    writeText(folder / "cm1out_s.dat", std::string(bytes, '\x01'));
    const ErrorParts error = errorOf([&] { openFiles({ctl}); });
    CHECK(contains(error.what, "record length at byte 0"));
    CHECK(error.found == "16843009");
    CHECK(error.expected == "80");
}

TEST_CASE("Templates with calendar times and with counts give the right file names") {
    for (const auto& [dset, tdef, second] : {
             std::tuple{"^c%y4%m2%d2_%h2%n2.bin", "tdef 2 linear 23:30Z28FEB2024 30mn\n",
                        "c20240229_0000.bin"},
             std::tuple{"^c_%t6.bin", "tdef 2 linear 00Z01jan2001 1hr\n", "c_000002.bin"},
             std::tuple{"^c_%iy4%imc_%f3.bin", "tdef 2 linear JAN2001 1dy\n", "c_2001jan_024.bin"},
             std::tuple{"^c_%y2%mc%d1.bin", "tdef 2 linear 12Z01DEC1999 1mo\n", "c_00jan1.bin"},
         }) {
        const TemporaryFolder folder;
        GradsSpec spec;
        spec.times = 1;
        spec.options = "template";
        spec.dset = dset;
        CAPTURE(spec.dset);
        spec.tdef = tdef;
        spec.metadata = false;
        spec.title = "units of x,y,z are m";
        const auto ctl = writeGrads(folder.path(), spec);
        std::filesystem::rename(folder / "cm1out_s.dat", folder / second);
        const auto dataset = openFiles({ctl});
        REQUIRE(dataset->info().times.size() == 1);
        CHECK(dataset->info().times[0].file.filename() == "cm1out_s.ctl");
        CHECK(dataset->info().model == "GrADS binary");
        CHECK(dataset->read("qc", 0).at(1, 0, 0) == gradsValue(4, 1, 0, 0, 0));
    }
}

TEST_CASE("A hydrometeor with fewer levels is zero above them, with a note") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.nz = 2;
    spec.zdef = "zdef 4 linear 0.05 0.1\n";
    const auto dataset = openFiles({writeGrads(folder.path(), spec)});
    const Array3f qc = dataset->read("qc", 0);
    CHECK(qc.size.z == 4);
    CHECK(qc.at(3, 2, 1) == gradsValue(4, 3, 2, 1, 0));
    CHECK(qc.at(3, 2, 2) == 0.0f);
    CHECK(dataset->read("qc", 0, CellBox{{0, 0, 2}, {5, 4, 4}}).at(4, 3, 1) == 0.0f);
    CHECK(contains(dataset->info().notes.at(0), "qc has 2 of 4 levels"));
    // Temperature and pressure on two levels are not enough: the standard atmosphere is used.
    CHECK(dataset->info().find("dry_air_density")->size == glm::ivec3(1, 1, 4));
}

TEST_CASE("Invalid descriptors are refused with line and reason") {
    const auto with = [](auto&& change) {
        GradsSpec spec;
        change(spec);
        return grammarError(spec);
    };
    CHECK(contains(with([](auto& s) { s.xdef = "xdef 5 levels 0 1 2 2 5\n"; }).what,
                   "positions of xdef do not increase"));
    CHECK(
        contains(with([](auto& s) { s.xdef = "xdef 5 levels 0 1 2\n"; }).what, "xdef has 3 of 5"));
    CHECK(contains(with([](auto& s) { s.xdef = "xdef 0 linear 0 1\n"; }).what, "xdef needs"));
    CHECK(contains(with([](auto& s) { s.xdef = "xdef 99999999999999999999 linear 0 1\n"; }).what,
                   "xdef needs"));
    CHECK(contains(with([](auto& s) { s.xdef = "pdef 5 5 lcc\nxdef 5 linear 0 1\n"; }).what,
                   "pdef is not supported"));
    CHECK(
        contains(with([](auto& s) { s.zdef = "zdef 3 levels 1 1 2\n"; }).what, "do not increase"));
    CHECK(contains(with([](auto& s) { s.zdef = "zdef 2 linear 0.1 0.1\n"; }).what, "more levels"));
    CHECK(contains(with([](auto& s) { s.options = "cray_32bit_ieee"; }).what, "not supported"));
    CHECK(contains(with([](auto& s) { s.tdef = "tdef 2 linear 32JAN2001 1hr\n"; }).what,
                   "not a time"));
    CHECK(contains(with([](auto& s) { s.tdef = "tdef 2 linear 1JAN9999 1yr\n"; }).what,
                   "not a calendar date"));
    CHECK(contains(with([](auto& s) {
                       s.options = "template";
                       s.dset = "^a%ch.dat";
                   }).what,
                   "template"));
    CHECK(contains(with([](auto& s) { s.variables[4] = "w {} 99 w (m/s)"; }).what,
                   "no variable is a hydrometeor"));
    CHECK(contains(with([](auto& s) { s.variables = {"u {} 99 u (m/s)"}; }).what,
                   "only staggered winds"));
    CHECK(contains(with([](auto& s) { s.variables.push_back("qc {} 99 qc (kg/kg)"); }).what,
                   "qc occurs twice"));
    CHECK(contains(with([](auto& s) { s.variables[4] = "qc {} -1,40,1 qc (kg/kg)"; }).what,
                   "storage layout that is not supported"));
    CHECK(contains(with([](auto& s) { s.xdef = "hello world\nxdef 5 linear 0 1\n"; }).what,
                   "line 4"));
}

TEST_CASE("The errors for a data file and for CM1's list of times name the descriptor to open") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.isTemplate = true;
    writeGrads(folder.path(), spec);
    CHECK(contains(errorOf([&] { openFiles({folder / "cm1out_000002_s.dat"}); }).hint,
                   "cm1out_s.ctl"));
    const ErrorParts list = errorOf([&] { openFiles({folder / "cm1out_metadata.ctl"}); });
    CHECK(contains(list.what, "list of times"));
    CHECK(contains(list.hint, "cm1out_s.ctl"));
    CHECK(openFiles({folder.path()})->info().times.size() == 2);
}

TEST_CASE("Scheme, droplet number and hail come from the namelist next to a CM1 descriptor") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.variables.push_back("qg {} 99 qg (kg/kg)");
    const auto ctl = writeGrads(folder.path(), spec);
    CHECK(openFiles({ctl})->info().microphysics == Microphysics::unknown);
    writeText(folder / "namelist.input",
              " &param2\n ptype = 5, ! Morrison\n ihail = 1,\n /\n ndcnst = 100.0\n");
    const DatasetInfo info = openFiles({ctl})->info();
    CHECK(info.scheme == "Morrison (ptype 5)");
    CHECK(info.microphysics == Microphysics::morrison);
    CHECK(info.cloudDropletsPerM3 == 1e8);
    CHECK(info.find(VariableRole::mixingRatio, Species::hail)->name == "qg");
    CHECK(info.find(VariableRole::mixingRatio, Species::graupel) == nullptr);
}

TEST_CASE("Times of cm1out_metadata that do not increase are ignored, with a note") {
    const TemporaryFolder folder;
    const std::filesystem::path ctl = writeGrads(folder.path(), GradsSpec{});
    writeFloats(folder / "cm1out_metadata.dat", {540.0f, 1.0f, 0.0f, 2.0f});
    const auto dataset = openFiles({ctl});
    CHECK(dataset->info().times.at(1).seconds > 0.0);
    CHECK(contains(dataset->info().notes.at(0), "cannot be read: times are numbered"));
}

TEST_CASE("Without cm1out_metadata times are numbered, with a note") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.metadata = false;
    const auto dataset = openFiles({writeGrads(folder.path(), spec)});
    CHECK(dataset->info().times[1].label == "time 2");
    CHECK(contains(dataset->info().notes.at(0), "cm1out_metadata"));
}
