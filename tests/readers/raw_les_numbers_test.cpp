// raw_les_numbers_test.cpp: what the numbers of a file show: byte order, record lengths, files that
// are being written; and units.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>

#include "tests/readers/raw_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void makeOld(const fs::path& path) {
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(1));
}

}  // namespace

TEST_CASE("A byte order that is not stated is the one in which the numbers are possible") {
    for (const bool airToo : {false, true}) {
        CAPTURE(airToo);
        const TemporaryFolder folder;
        GradsSpec spec;
        spec.swappedUnsaid = true;
        if (!airToo) spec.variables = {"qc {} 99 qc (kg/kg)"};
        const auto dataset = openFiles({writeGrads(folder.path(), spec)});
        const std::size_t qc = airToo ? 4 : 0;
        CHECK(dataset->read("qc", 1).at(4, 3, 2) == gradsValue(qc, 4, 3, 2, 1));
        CHECK(hasNote(dataset->info(), "does not state the byte order"));
        CHECK(hasNote(dataset->info(), "big-endian is assumed"));
        CHECK(dataset->info().times[0].label == "540 s");  // of a list in the other order
    }
}

TEST_CASE("A list of times in the same unstated byte order is read as well") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.swappedUnsaid = true;
    const auto ctl = writeGrads(folder.path(), spec);
    writeFloats(folder / "cm1out_metadata.dat", {540.0f, 1.0f, 720.0f, 2.0f}, true);
    CHECK(openFiles({ctl})->info().times[1].label == "720 s");
}

TEST_CASE("The first time with condensate decides on the byte order of hydrometeors alone") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.nx = spec.ny = 12;
    spec.swappedUnsaid = true;
    spec.variables = {"qc {} 99 qc (kg/kg)"};
    spec.value = [](auto, auto x, auto y, auto z, auto t) {
        return t == 0 ? 0.0f : 1.1e-4f * static_cast<float>(x + y + z);
    };
    const auto dataset = openFiles({writeGrads(folder.path(), spec)});
    CHECK(dataset->read("qc", 1).at(1, 1, 1) == 1.1e-4f * 3.0f);
}

TEST_CASE("A stated byte order that is wrong is refused with the option to change") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.options = "big_endian";
    const auto ctl = writeGrads(folder.path(), spec);
    const ErrorParts error = errorOf([&] { openFiles({ctl}); });
    CHECK(contains(error.what, "byte order"));
    CHECK(contains(error.found, "100 % as little-endian"));
    CHECK(contains(error.hint, "little_endian"));
    CHECK(contains(error.where, "cm1out_s.dat"));
}

TEST_CASE("Record lengths show the byte order where it is not stated") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.sequential = spec.swappedUnsaid = true;
    const auto dataset = openFiles({writeGrads(folder.path(), spec)});
    CHECK(dataset->read("qc", 1).at(4, 3, 2) == gradsValue(4, 4, 3, 2, 1));
    CHECK(hasNote(dataset->info(), "record lengths show"));
}

TEST_CASE("Record lengths that are not stated, or stated and absent, are refused with the option") {
    for (const bool swapped : {false, true}) {
        const TemporaryFolder folder;
        GradsSpec spec;
        spec.sequential = true;
        spec.swappedUnsaid = swapped;
        const auto ctl = writeGrads(folder.path(), spec);
        std::string text = textOf(ctl);
        text.erase(text.find("options"), text.find("title") - text.find("options"));
        writeText(ctl, text);
        const ErrorParts error = errorOf([&] { openFiles({ctl}); });
        CHECK(contains(error.what, "has Fortran record lengths"));
        CHECK(contains(error.hint,
                       swapped ? "'options sequential byteswapped'" : "'options sequential'"));
    }
    const TemporaryFolder folder;
    GradsSpec spec;
    const auto ctl = writeGrads(folder.path(), spec);
    writeText(ctl, "options sequential\n" + textOf(ctl));
    const ErrorParts error = errorOf([&] { openFiles({ctl}); });
    CHECK(contains(error.what, "has no Fortran record lengths"));
    CHECK(contains(error.hint, "remove sequential"));
}

TEST_CASE("One Fortran record for each variable is told from one for each level") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.times = 1;
    spec.variables = {"qc {} 99 qc (kg/kg)", "qr {} 99 qr (kg/kg)"};
    const auto ctl = writeGrads(folder.path(), spec);
    std::string records;
    for (int i = 0; i < 2; ++i) {
        const std::string length("\xf0\0\0\0", 4);  // 5 x 4 x 3 floats
        records += length + std::string(240, '\0') + length;
    }
    writeText(folder / "cm1out_s.dat", records);
    CHECK(
        contains(errorOf([&] { openFiles({ctl}); }).what, "one Fortran record for each variable"));
}

TEST_CASE("A file of all times that ends within one keeps those before it") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.nx = 20;
    spec.times = 3;
    const auto ctl = writeGrads(folder.path(), spec);
    const fs::path data = folder / "cm1out_s.dat";
    const auto whole = fs::file_size(data);
    for (const std::uintmax_t bytes : {whole - 5, whole - whole / 3}) {
        fs::resize_file(data, bytes);
        const auto dataset = openFiles({ctl});
        REQUIRE(dataset->info().times.size() == 2);
        CHECK(hasNote(dataset->info(), "time 3 of 3, because it is being written"));
        CHECK(dataset->read("qc", 1).at(4, 3, 2) == gradsValue(4, 4, 3, 2, 1));
    }
    makeOld(data);
    CHECK(hasNote(openFiles({ctl})->info(), "ends before time 3 of 3: only"));
}

TEST_CASE("A file of another size whose numbers do not bear out the descriptor is refused") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.nx = 20;
    const auto ctl = writeGrads(folder.path(), spec);
    const fs::path data = folder / "cm1out_s.dat";
    const std::string bytes = textOf(data);
    writeText(data, bytes.substr(400));  // as if xdef or the variables were of another run
    const ErrorParts writing = errorOf([&] { openFiles({ctl}); });
    CHECK(contains(writing.what, "is being written"));
    CHECK(contains(writing.what, "shorter than its descriptor"));
    CHECK(contains(writing.hint, "open it again"));
    makeOld(data);
    const ErrorParts old = errorOf([&] { openFiles({ctl}); });
    CHECK(old.what == "is shorter than its descriptor states");
    CHECK(contains(old.hint, "interrupted"));
}

TEST_CASE("A file of a time that has another size than the others loses itself alone") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.isTemplate = true;
    spec.times = 3;
    const auto ctl = writeGrads(folder.path(), spec);
    fs::resize_file(folder / "cm1out_000002_s.dat", 100);
    CHECK(hasNote(openFiles({ctl})->info(), "cm1out_000002_s.dat (being written)"));
    makeOld(folder / "cm1out_000002_s.dat");
    const auto dataset = openFiles({ctl});
    REQUIRE(dataset->info().times.size() == 2);
    CHECK(hasNote(dataset->info(),
                  "1 of 3 times are left out, because their files have another size"));
    CHECK(dataset->read("qc", 1).at(4, 3, 2) == gradsValue(4, 4, 3, 2, 2));
    fs::remove(folder / "cm1out_000003_s.dat");
    CHECK(hasNote(openFiles({ctl})->info(), "2 of 3 times are left out"));
}

TEST_CASE("Units are converted with their offset, in any spelling") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.times = 1;
    spec.title = "a model; units of x,y,z are km";
    spec.variables = {"tc {} 99 temperature (C)", "pressure {} 99 pressure (hPa)",
                      "qvapor {} 99 vapour (G/KG)", "qcloud {} 99 cloud (g kg-1)",
                      "nc {} 99 droplets (/kg)"};
    spec.value = [](auto v, auto, auto, auto, auto) {
        constexpr std::array kValues{20.0f, 900.0f, 8.0f, 0.5f, 1e8f};
        return kValues[v];
    };
    const auto dataset = openFiles({writeGrads(folder.path(), spec)});
    CHECK(dataset->read("tc", 0).values[0] == doctest::Approx(293.15));
    CHECK(dataset->read("pressure", 0).values[0] == doctest::Approx(9e4));
    CHECK(dataset->read("qcloud", 0).values[0] == doctest::Approx(5e-4));
    CHECK(dataset->info().find(VariableRole::numberConcentration, Species::cloud) != nullptr);
    // p / (R_d T (1 + q R_v / R_d)) with CM1's constants.
    CHECK(dataset->read("dry_air_density", 0).values[0] ==
          doctest::Approx(9e4 / (287.04 * 293.15 * (1.0 + 0.008 * 461.5 / 287.04))));
}

TEST_CASE("A unit of another kind is refused for air, and leaves a helper unused with a note") {
    GradsSpec spec;
    spec.variables[2] = "prs {} 99 pressure (m)";
    const TemporaryFolder folder;
    const ErrorParts error = errorOf([&] { openFiles({writeGrads(folder.path(), spec)}); });
    CHECK(contains(error.what, "unit of variable prs"));
    CHECK(contains(error.expected, "hPa"));
    spec.variables[2] = "prs {} 99 pressure (Pa)";
    spec.variables.push_back("nci {} 99 ice crystals (1/m3)");
    spec.variables.push_back("effc {} 99 radius");
    const DatasetInfo info = openFiles({writeGrads(folder.path(), spec)})->info();
    CHECK(hasNote(info, "nci (1/m3), effc (no unit): are not used"));
}

TEST_CASE("Air that is impossible makes what is derived from it missing") {
    const TemporaryFolder folder;
    GradsSpec spec;
    spec.times = 1;
    spec.value = [](std::size_t v, std::size_t x, std::size_t, std::size_t, std::size_t) {
        constexpr std::array kValues{0.0f, 300.0f, 9e4f, 0.008f, 1e-3f};
        return v == 2 && x == 0 ? -5.0f : kValues[v];
    };
    const auto dataset = openFiles({writeGrads(folder.path(), spec)});
    CHECK(std::isnan(dataset->read("air_temperature", 0).values[0]));
    CHECK(std::isnan(dataset->read("dry_air_density", 0).values[0]));
    CHECK(dataset->read("dry_air_density", 0).values[1] > 1.0f);
}

TEST_CASE("A mark at the start of a text file is no part of it") {
    const TemporaryFolder folder;
    const auto ctl = writeGrads(folder.path(), GradsSpec{});
    writeText(ctl, "\xef\xbb\xbf" + textOf(ctl));
    CHECK(openFiles({ctl})->info().times.size() == 2);
    const TemporaryFolder other;
    writeMicrohh(other.path(), {});
    writeText(other / "case.ini", "\xef\xbb\xbf" + textOf(other / "case.ini"));
    CHECK(openFiles({other.path()})->info().times.size() == 2);
}
