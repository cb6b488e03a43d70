// grib_contents_test.cpp: which fields of GRIB2 files are read, and what is said of the others.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "tests/readers/grib_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

GribFunction constantly(double value) {
    return [value](int, int, int, int) { return value; };
}

std::shared_ptr<Dataset> openSpec(const TemporaryFolder& folder, const GribSpec& spec) {
    writeGrib(folder / "a", spec);
    age(folder / "a");
    return openFiles({folder / "a"});
}

}  // namespace

TEST_CASE("A GRIB2 file of HRRR's native levels is described in full") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.hours = {0, 3};
    spec.fields["NCONCD"] = constantly(1e8);
    spec.fields["DZDT"] = [](int, int, int z, int) { return 2.0 * z; };
    spec.ground["HGT"] = constantly(0.0);
    const auto dataset = openSpec(folder, spec);
    const DatasetInfo& info = dataset->info();
    CHECK(info.reader == "grib");
    CHECK(info.model == "HRRR");
    CHECK(info.microphysics == Microphysics::thompson);
    REQUIRE(info.times.size() == 2);
    CHECK(info.times[0].label == "2021-08-14_18:00:00");
    CHECK(info.times[1].label == "2021-08-14_21:00:00");
    CHECK(info.times[1].seconds - info.times[0].seconds == 10800.0);
    for (const Species species :
         {Species::cloud, Species::ice, Species::rain, Species::snow, Species::graupel}) {
        CHECK(info.find(VariableRole::mixingRatio, species) != nullptr);
    }
    CHECK(info.find(VariableRole::mixingRatio, Species::ice)->name == "CIMIXR");
    CHECK(info.find(VariableRole::numberConcentration, Species::cloud)->name == "NCONCD");
    const auto wind =
        std::ranges::find(info.variables, "upward_air_velocity", &VariableInfo::standardName);
    REQUIRE(wind != info.variables.end());
    CHECK(wind->units == "m s-1");
    CHECK(dataset->read(wind->name, 1).at(0, 0, 2) == 4.0f);
    CHECK_FALSE(hasNote(info, "has no"));
}

TEST_CASE("Winds along the grid are told from those to the east and north") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.fields["UGRD"] = constantly(5.0);
    for (const long alongGrid : {0L, 1L}) {
        spec.keys["uvRelativeToGrid"] = alongGrid;
        const auto dataset = openSpec(folder, spec);
        const auto& found = dataset->info().variables;
        const auto wind = std::ranges::find(found, alongGrid == 1 ? "x_wind" : "eastward_wind",
                                            &VariableInfo::standardName);
        REQUIRE(wind != found.end());
        CHECK(dataset->read(wind->name, 0).at(0, 0, 0) == 5.0f);
    }
}

TEST_CASE("Hybrid levels that are counted from the top are turned") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.downward = true;
    spec.fields["CLMR"] = [](int, int, int z, int) { return 1e-3 * (z + 1); };
    const auto dataset = openSpec(folder, spec);
    CHECK(dataset->read("interface_height", 0).at(0, 0, 1) == 100.0f);
    CHECK(dataset->read("CLMR", 0).at(0, 0, 0) < dataset->read("CLMR", 0).at(0, 0, 2));
}

TEST_CASE("On isobaric levels the pressure is that of the level, and nothing is below the ground") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.isobaric = true;
    spec.fields["CLMR"] = constantly(1e-3);
    spec.ground["HGT"] = [](int x, int, int, int) { return x == 1 ? 100.0 : 0.0; };
    const auto dataset = openSpec(folder, spec);
    const DatasetInfo& info = dataset->info();
    CHECK(dataset->read("air_pressure", 0).at(0, 0, 2) == 80000.0f);
    const Array3f cloud = dataset->read("CLMR", 0);
    CHECK(cloud.at(0, 0, 0) == doctest::Approx(1e-3));
    CHECK(std::isnan(cloud.at(1, 0, 0)));  // its centre is at 50 m
    CHECK(cloud.at(1, 0, 1) == doctest::Approx(1e-3));
    // Half a layer below the lowest centre.
    CHECK(dataset->read("interface_height", 0).at(1, 0, 0) == 0.0f);
    CHECK(hasNote(info, "below HGT of the ground are empty"));
    spec.ground.clear();
    spec.ground["PRES"] = [](int x, int, int, int) { return x == 1 ? 95000.0 : 102000.0; };
    const auto byPressure = openSpec(folder, spec);
    CHECK(std::isnan(byPressure->read("CLMR", 0).at(1, 0, 0)));
    CHECK(byPressure->read("CLMR", 0).at(0, 0, 0) == doctest::Approx(1e-3));
    spec.ground.clear();
    CHECK(hasNote(openSpec(folder, spec)->info(), "neither HGT nor PRES of the ground"));
}

TEST_CASE("Isobaric levels that are masked below the ground are empty there") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.isobaric = true;
    spec.fields["CLMR"] = constantly(1e-3);
    spec.missing = [](const std::string&, int x, int, int z) { return x == 1 && z < 2; };
    const auto dataset = openSpec(folder, spec);
    const Array3f cloud = dataset->read("CLMR", 0), heights = dataset->read("interface_height", 0);
    CHECK(std::isnan(cloud.at(1, 0, 1)));
    CHECK(cloud.at(1, 0, 2) == doctest::Approx(1e-3));
    for (int k = 0; k < 3; ++k) CHECK(heights.at(1, 0, k + 1) > heights.at(1, 0, k));
    // A scale height of 288.15 K times ln(900 / 800) below the centre at 250 m, and halfway.
    const double scaleHeight = 287.0 * 288.15 / 9.80665;
    CHECK(heights.at(1, 0, 2) == doctest::Approx(250.0 - 0.5 * scaleHeight * std::log(9.0 / 8.0)));
    CHECK(dataset->read("dry_air_density", 0).at(1, 0, 0) > 1.0f);
}

TEST_CASE("Vapour follows from relative humidity or dew point where there is no SPFH") {
    const TemporaryFolder folder;
    // Saturation over water at 10 °C: 12.27 hPa in the tables of the WMO (guide 8, annex 4.B);
    // at 1000 hPa a mixing ratio of 7.73 g/kg.
    GribSpec spec;
    spec.nz = 10;  // the highest at 100 hPa
    spec.isobaric = true;
    spec.omit = {"SPFH"};
    spec.fields["TMP"] = constantly(283.15);
    spec.fields["RH"] = constantly(100.0);
    auto dataset = openSpec(folder, spec);
    CHECK(static_cast<double>(dataset->read("humidity_mixing_ratio", 0).at(0, 0, 0)) ==
          doctest::Approx(7.73e-3).epsilon(2e-3));
    CHECK(dataset->read("humidity_mixing_ratio", 0).at(0, 0, 9) == 0.0f);
    CHECK(dataset->read("humidity_mixing_ratio", 0).at(0, 0, 8) > 0.01f);
    CHECK(hasNote(dataset->info(), "Water vapour follows from RH"));
    spec.fields.erase("RH");
    spec.fields["DPT"] = constantly(283.15);
    dataset = openSpec(folder, spec);
    CHECK(static_cast<double>(dataset->read("humidity_mixing_ratio", 0).at(0, 0, 0)) ==
          doctest::Approx(7.73e-3).epsilon(2e-3));
    spec.fields.erase("DPT");
    CHECK(hasNote(openSpec(folder, spec)->info(), "the air is treated as dry"));
}

TEST_CASE("Content per kg of moist air is converted to dry air") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.omit = {"CLMR"};
    spec.fields["SPFH"] = constantly(0.02);
    spec.fields["CLWC"] = constantly(1e-3);
    const auto dataset = openSpec(folder, spec);
    CHECK(static_cast<double>(dataset->read("CLWC", 0).at(2, 2, 1)) ==
          doctest::Approx(1e-3 / 0.98).epsilon(1e-5));
}

TEST_CASE("What a GRIB2 file lacks or has twice is in the notes") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.nz = 4;
    spec.hours = {0, 1, 2};
    spec.omit = {"GRLE"};
    spec.process = 12;
    spec.fields["ICMR"] = constantly(1e-5);
    spec.lacks = [](const std::string& name, int z, int t) {
        return (name == "TMP" && (z == 3 || (t == 1 && z == 2))) ||
               (name == "RWMR" && z == 1 && t == 2);
    };
    const auto dataset = openSpec(folder, spec);
    const DatasetInfo& info = dataset->info();
    CHECK(info.size.z == 3);
    REQUIRE(info.times.size() == 2);
    CHECK(info.times[1].label == "2021-08-14_20:00:00");
    CHECK(hasNote(info, "The file has no graupel"));
    CHECK(hasNote(info, "ICMR is not used"));
    CHECK(hasNote(info, "1 levels lack height, pressure or temperature"));
    CHECK(hasNote(info, "The time 2021-08-14_19:00:00 is left out: it has 2 of 3 levels"));
    CHECK(hasNote(info, "RWMR lacks 1 of 3 levels at 2021-08-14_20:00:00"));
    CHECK(hasNote(info, "process 12 of centre 7 is not known"));
    CHECK(std::isnan(dataset->read("RWMR", 1).at(0, 0, 1)));
    CHECK(dataset->read("RWMR", 0).at(0, 0, 1) == 0.0f);
}

TEST_CASE("Files of one run and several forecast hours form a series") {
    const TemporaryFolder folder;
    for (const int hour : {2, 0, 1}) {
        GribSpec spec;
        spec.hours = {hour};
        spec.fields["CLMR"] = constantly(1e-4 * (hour + 1));
        writeGrib(folder / ("hrrr.t18z.wrfnatf0" + std::to_string(hour) + ".grib2"), spec);
    }
    const auto dataset = openFiles({folder.path()});
    REQUIRE(dataset->info().times.size() == 3);
    for (int t = 0; t < 3; ++t) {
        CHECK(dataset->read("CLMR", t).at(0, 0, 0) == doctest::Approx(1e-4 * (t + 1)));
    }
}

TEST_CASE("Files without levels, and GRIB of edition 1, are refused with a step") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.omit = {"PRES"};
    writeGrib(folder / "a", spec);
    const ErrorParts lacking = openError(folder / "a");
    CHECK(contains(lacking.what, "no levels with height, pressure and temperature"));
    CHECK(contains(lacking.found, "HGT on 3"));
    CHECK(contains(lacking.hint, "wrfnat"));
    writeGribSample(folder / "b", "GRIB1");
    const ErrorParts first = openError(folder / "b");
    CHECK(contains(first.what, "edition 1"));
    CHECK(contains(first.hint, "cnvgrib -g12"));
}

TEST_CASE("GRIB2 messages that are cut short or damaged are left out with a note") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.nz = 4;
    auto messages = gribMessages(spec);
    REQUIRE(messages.size() == 36);
    std::uintmax_t bytes = 0;
    for (const GribMessage& message : messages) bytes += message.size();
    writeMessages(folder / "cut", messages);
    truncateTo(folder / "cut", bytes - 20);
    const auto cut = openFiles({folder / "cut"});
    CHECK(cut->info().size.z == 3);  // TMP of the highest level is the last message
    CHECK(hasNote(cut->info(), "The file is cut short"));
    std::filesystem::last_write_time(folder / "cut", std::filesystem::file_time_type::clock::now());
    CHECK(hasNote(openFiles({folder / "cut"})->info(), "The file is being written"));
    // Within the second message: what is missing is not there yet.
    truncateTo(folder / "cut", messages[0].size() + 100);
    const ErrorParts within = openError(folder / "cut");
    CHECK(contains(within.found, "the file is cut short"));
    CHECK(contains(within.hint, "download"));
    truncateTo(folder / "cut", 100);
    CHECK(contains(openError(folder / "cut").what, "cut short"));
    // Message 2 is CLMR of the lowest level: sections of wrong length.
    messages[1][16 + 3] = 200;
    writeMessages(folder / "damaged", messages);
    const auto damaged = openFiles({folder / "damaged"});
    CHECK(damaged->info().size.z == 4);
    CHECK(hasNote(damaged->info(),
                  "1 of 36 messages is damaged and left out, the first of them "
                  "message 2"));
    CHECK(hasNote(damaged->info(), "CLMR lacks 1 of 4 levels"));
}

TEST_CASE("A GRIB2 field that cannot be unpacked is named with its message") {
    const TemporaryFolder folder;
    GribSpec spec;
    spec.nx = 40;
    spec.ny = 30;
    spec.packing = "complex";
    spec.fields["CLMR"] = [](int x, int y, int z, int) { return 1e-5 * ((x * y + z) % 17); };
    auto messages = gribMessages(spec);
    // The number of groups of message 2, at octets 32 to 35 of its section 5.
    const std::array<std::uint8_t, 5> head{0, 0, 0, 49, 5};
    const auto section =
        std::search(messages[1].begin(), messages[1].end(), head.begin(), head.end());
    REQUIRE(section != messages[1].end());
    section[33] = 1;
    writeMessages(folder / "a", messages);
    const auto dataset = openFiles({folder / "a"});
    const ErrorParts error = errorOf([&] { dataset->read("CLMR", 0); });
    CHECK(contains(error.what, "message 2, CLMR on hybrid level 1"));
    CHECK(dataset->read("RWMR", 0).at(0, 0, 0) == 0.0f);  // the others are whole
}

TEST_CASE("GRIB2 behind the headings of bulletins is found") {
    const TemporaryFolder folder;
    auto messages = gribMessages({});
    const std::string heading = "\x01\r\r\n001\r\r\nYCWX10 KWBC 141800\r\r\n";
    for (GribMessage& message : messages) {
        message.insert(message.begin(), heading.begin(), heading.end());
        for (const char c : {'\r', '\r', '\n', '\x03'}) {
            message.push_back(static_cast<std::uint8_t>(c));
        }
    }
    writeMessages(folder / "a", messages);
    CHECK(openFiles({folder / "a"})->info().size == glm::ivec3(5, 4, 3));
}
