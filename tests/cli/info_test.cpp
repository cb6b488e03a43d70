// info_test.cpp: `nephoscope info` and `nephoscope readers`, run as a user runs them.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"
#include "tests/environment.h"
#include "tests/readers/les_maker.h"
#include "tests/readers/nested_run.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

namespace {

const std::string kStorm = "'" NEPH_TEST_SOURCE_DIR "/samples/supercell'";

}  // namespace

TEST_CASE("info tells model, scheme, grid, times and where each hydrometeor is densest") {
    const Outcome outcome = runProgram("info " + kStorm);
    CHECK(outcome.status == 0);
    for (const char* part :
         {"WRF V4.2.2", "Thompson (MP_PHYSICS 8)", "110 x 120 x 60 cells of 1 km", "110 x 120 km",
          "Cloud    base 0.00 km, top 15.46 km", "at full resolution",
          "0001-01-01_00:30:00 to 0001-01-01_02:00:00, 90 min, every 30 min",
          "Bases    of cloudy columns: 5th percentile ", "main updraft (", "updraft   top km",
          "Humidity 65 to 71 % in the lowest layer; visibility by it (sky.haze=humidity) 29 to "
          "33.3 "
          "km"}) {
        CAPTURE(part);
        CHECK(contains(outcome.out, part));
    }
    // 14.22119 g/kg at one hour, by ncwa -y max.
    CHECK(contains(outcome.out, "14.2"));
}

TEST_CASE("info --json has it all, as numbers") {
    const Outcome outcome = runProgram("info --json " + kStorm);
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json.at("type") == "nephoscope-info");
    CHECK(json.at("version") == 1);
    CHECK(json.at("grid").at("size") == nlohmann::json({110, 120, 60}));
    CHECK(json.at("grid").at("domain_km") == nlohmann::json({110.0, 120.0}));
    REQUIRE(json.at("times").size() == 4);
    CHECK(json.at("times")[2].at("seconds") == 3600.0);
    CHECK(json.at("times")[1].at("maxima").size() == 5);
    const auto& rain = json.at("times")[1].at("maxima")[2];
    CHECK(rain.at("species") == "rain");
    CHECK(rain.at("maximum_g_per_kg").get<double>() == doctest::Approx(14.09912));
    CHECK(rain.at("height_km").get<double>() < 5.0);
    CHECK(json.at("species")[4].at("time") == "0001-01-01_01:30:00");
    // As in supercell_test.cpp; the visibility by the formula of docs/sky.md.
    const auto& lowest = json.at("times")[1].at("lowest_layer");
    CHECK(lowest.at("relative_humidity").get<double>() == doctest::Approx(0.663426).epsilon(1e-5));
    CHECK(lowest.at("visibility_by_humidity_km").get<double>() ==
          doctest::Approx(32.5608).epsilon(1e-4));
    CHECK(json.at("notes").empty());
}

TEST_CASE("info gives cloud base and top and the heaviest columns as an independent sum has them") {
    // By numpy on what ncdump prints: q times p / (287 T_K (1 + 1.6084 q_v)) times the depth of
    // layers.
    const Outcome outcome = runProgram("info --json " + kStorm);
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    const auto number = [&](const char* pointer) {
        return json.at(nlohmann::json::json_pointer(pointer)).get<double>();
    };
    CHECK(number("/condensate/maximum_kg_per_m2") == doctest::Approx(107.22).epsilon(1e-4));
    CHECK(number("/condensate/x_km") == 30.5);
    CHECK(number("/condensate/y_km") == 94.5);
    CHECK(json.at("condensate").at("time") == "0001-01-01_02:00:00");
    CHECK(number("/species/4/column/maximum_kg_per_m2") == doctest::Approx(68.691).epsilon(1e-4));
    CHECK(number("/species/4/column/y_km") == 93.5);
    CHECK(number("/times/0/maxima/2/column/maximum_kg_per_m2") ==
          doctest::Approx(36.113).epsilon(1e-4));
    CHECK(number("/times/0/cloud/base_km") == doctest::Approx(0.750893).epsilon(1e-5));
    CHECK(number("/times/0/cloud/top_km") == doctest::Approx(13.867420).epsilon(1e-5));
    CHECK(number("/times/0/precipitation/base_km") == 0.0);
    CHECK(number("/times/3/precipitation/top_km") == doctest::Approx(16.803547).epsilon(1e-5));
    CHECK(json.at("shown") == "at full resolution");
    CHECK(contains(outcome.out, "\"cloud_threshold_g_per_kg\": 0.01,"));
}

TEST_CASE("info tells place, dates and the sun over the middle of the grid, where the data do") {
    // Brasilia at 2010-03-15 12:30 UTC: azimuth 76.249630, zenith angle 44.139862 degrees by NREL's
    // SPA [Reda04] (spa_reference_testdata.csv of github.com/klausbrunner/solarpositioning).
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.mapProjection = 6;
    spec.dx = spec.dy = 1111.775f;  // 0.01 degrees on WRF's sphere
    spec.times = {"2010-03-15_12:30:00"};
    spec.attributes = {{"POLE_LAT", 90.0}, {"POLE_LON", 0.0}, {"STAND_LON", 0.0}};
    spec.flat["XLAT"] = [](int, int y, int, int) {
        return static_cast<float>(-15.793889 + 0.01 * (y - 1));
    };
    spec.flat["XLONG"] = [](int x, int, int, int) {
        return static_cast<float>(-47.882778 + 0.01 * (x - 1.5));
    };
    writeWrf(folder / "a", spec);
    const std::string path = "'" + (folder / "a").string() + "'";
    const Outcome outcome = runProgram("info --json " + path);
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    const auto number = [&](const char* pointer) {
        return json.at(nlohmann::json::json_pointer(pointer)).get<double>();
    };
    const auto near = [&](const char* pointer, double expected, double tolerance) {
        CAPTURE(pointer);
        CAPTURE(number(pointer));
        CHECK(std::abs(number(pointer) - expected) < tolerance);
    };
    CHECK(contains(json.at("place").at("projection").get<std::string>(), "+proj=eqc"));
    near("/place/middle/latitude_deg", -15.793889, 1e-4);
    near("/place/middle/longitude_deg", -47.882778, 1e-4);
    near("/place/corners/south_west/latitude_deg", -15.793889 - 0.015, 1e-4);
    near("/place/corners/north_east/longitude_deg", -47.882778 + 0.02, 1e-4);
    near("/place/convergence_deg", 0.0, 1e-4);
    near("/place/map_factor/least", 1.0, 1e-4);
    near("/place/map_factor/greatest", 1.0 / std::cos(15.8 * 3.14159265 / 180.0), 1e-3);
    CHECK(json.at("times")[0].at("utc") == "2010-03-15T12:30:00Z");
    near("/times/0/sun/apparent_elevation_deg", 90.0 - 44.139862, 0.01);
    near("/times/0/sun/azimuth_deg", 76.249630, 0.01);
    const std::string text = runProgram("info " + path).out;
    for (const char* part : {"15.79 S 47.88 W in the middle", "Date     2010-03-15T12:30:00Z",
                             "true north 0.00 deg", "45.86", "76.25"}) {
        CAPTURE(part);
        CHECK(contains(text, part));
    }
}

TEST_CASE("info says that an idealised run has no place and no date") {
    const TemporaryFolder folder;
    writeWrf(folder / "a", WrfSpec{});
    const std::string path = "'" + (folder / "a").string() + "'";
    const auto json = nlohmann::json::parse(runProgram("info --json " + path).out);
    CHECK(json.at("place").is_null());
    CHECK(json.at("no_place") == "the run is idealised (MAP_PROJ 0)");
    CHECK(json.at("times")[0].at("utc").is_null());
    CHECK(json.at("times")[0].at("sun").is_null());
    const std::string text = runProgram("info " + path).out;
    CHECK(contains(text, "Place    not known: the run is idealised (MAP_PROJ 0)"));
    CHECK(contains(text, "Date     not known"));
}

TEST_CASE("info --time reads the times asked for and says how many that were") {
    const Outcome outcome = runProgram("info --json --time 1 " + kStorm);
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(!json.at("times")[0].contains("maxima"));
    CHECK(json.at("times")[1].contains("maxima"));
    CHECK(json.at("notes")[0] == "1 of 4 times were read; --time all reads every one.");
    CHECK(contains(runProgram("info --time 9 " + kStorm).err, "error"));
}

TEST_CASE("A time that is refused is named, and the others are summarised") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.times = {"2021-08-14_18:00:00", "2021-08-14_18:10:00"};
    spec.fields["QCLOUD"] = [](int, int, int, int) { return 1e-3f; };
    spec.fields["P"] = [](int x, int, int, int t) { return t == 1 && x == 2 ? 1e9f : 0.0f; };
    writeWrf(folder / "a", spec);
    const std::string path = "'" + (folder / "a").string() + "'";
    const Outcome outcome = runProgram("info --json " + path);
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json.at("species")[0].at("time") == "2021-08-14_18:00:00");
    REQUIRE(json.at("notes").size() >= 1);
    CHECK(contains(json.at("notes")[0].get<std::string>(), "2021-08-14_18:10:00 cannot be shown"));
    CHECK(runProgram("info --time 1 " + path).status == 1);
}

TEST_CASE("info on what cannot be read fails with file, found, expected and hint") {
    const Outcome outcome = runProgram("info '" NEPH_TEST_SOURCE_DIR "/LICENSE'");
    CHECK(outcome.status == 1);
    CHECK(outcome.err.starts_with("error: "));
    for (const char* part : {"LICENSE", "found:", "expected: ", "WRF output", "hint:"}) {
        CHECK(contains(outcome.err, part));
    }
}

TEST_CASE("readers lists the plugin with file, version and ABI, and why another was rejected") {
    const Outcome outcome = runProgram("readers");
    CHECK(outcome.status == 0);
    for (const char* part : {"wrf_netcdf 1.2", "wrf_netcdf.so", "ABI         3", "Looked for in"}) {
        CHECK(contains(outcome.out, part));
    }
    const Environment path("NEPHOSCOPE_READER_PATH", NEPH_TEST_SOURCE_DIR "/LICENSE");
    const Outcome rejected = runProgram("readers");
    CHECK(contains(rejected.out, "Rejected"));
    CHECK(contains(rejected.out, "LICENSE: "));
}

TEST_CASE("info lists where a grid that moves lies at each time, and the sun over it there") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.mapProjection = 6;
    spec.dx = spec.dy = 1111.775f;  // 0.01 degrees on WRF's sphere
    spec.times = {"2010-03-15_12:30:00", "2010-03-15_12:40:00"};
    spec.attributes = {{"POLE_LAT", 90.0}, {"POLE_LON", 0.0}, {"STAND_LON", 0.0}};
    spec.flat["XLAT"] = [](int, int y, int, int) { return static_cast<float>(0.02 + 0.01 * y); };
    spec.flat["XLONG"] = [](int x, int, int, int t) {
        return static_cast<float>(10.0 + 0.01 * (x + 300 * t));
    };
    writeWrf(folder / "a", spec);
    const std::string path = "'" + (folder / "a").string() + "'";
    const auto json = nlohmann::json::parse(runProgram("info --json " + path).out);
    const auto& times = json.at("times");
    CHECK(times[0].at("grid_offset_m") == nlohmann::json({0.0, 0.0}));
    CHECK(times[1].at("grid_offset_m")[0].get<double>() ==
          doctest::Approx(300.0 * json.at("grid").at("spacing_m")[0].get<double>()));
    CHECK(std::abs(times[1].at("south_west").at("longitude_deg").get<double>() - 12.995) < 1e-4);
    // Near the equator near an equinox, after noon: 3 degrees further east and ten minutes later
    // the sun is about 3 + 2.5 degrees lower.
    CHECK(times[1].at("sun").at("elevation_deg").get<double>() -
              times[0].at("sun").at("elevation_deg").get<double>() <
          -5.0);
    CHECK(contains(runProgram("info " + path).out, "Corner of the grid"));
}

TEST_CASE(
    "readers --explain says what each variable was taken for and why, and what was left out") {
    const TemporaryFolder folder;
    LesFile file = cm1Sample();
    file.variables.push_back(field("qfog", file.variable("qc").axes, "kg/kg", constant(1e-4)));
    writeLes(folder / "cm1out_000001.nc", file);
    const std::string path = "'" + (folder / "cm1out_000001.nc").string() + "'";
    const Outcome outcome = runProgram("readers --explain " + path);
    CHECK(outcome.status == 0);
    for (const char* part :
         {"Reader   cf_les", "Model    CM1 r21.1", "mixing_ratio of cloud",
          "CM1 writes cloud water under this name", "Without a role: ", "uinterp",
          "qfog: is listed and not drawn", "computed: from potential temperature"}) {
        CAPTURE(part);
        CHECK(contains(outcome.out, part));
    }
    const auto json = nlohmann::json::parse(runProgram("info --json " + path).out);
    CHECK(json.at("times").at(1).at("grid_offset_m") == nlohmann::json({11250.0, -1800.0}));
    CHECK(contains(runProgram("info " + path).out, "Corner of the grid"));
}

TEST_CASE("--map names what an unknown file holds, and is refused where nothing is opened") {
    const TemporaryFolder folder;
    writeLes(folder / "a.nc", cm1Sample());
    std::ofstream(folder / "m.json") << R"({"type": "nephoscope-map", "version": 1,
        "axes": {"x": "xh", "y": "yh", "z": "zh"}, "length_unit": "km",
        "variables": [{"name": "qg", "role": "mixing_ratio", "species": "cloud"}]})";
    const std::string map = "--map '" + (folder / "m.json").string() + "'";
    const std::string path = "'" + (folder / "a.nc").string() + "'";
    CHECK(contains(runProgram("readers " + map + " --explain " + path).out, "the map states it"));
    CHECK(contains(runProgram("info " + map + " " + path).out, "those of m.json"));
    CHECK(runProgram("readers " + map).status == 2);
    CHECK(contains(runProgram("info --map nowhere.json " + path).err, "no such map"));
}

TEST_CASE("info lists the domains of a nested run, and render shows them as one") {
    const TemporaryFolder folder;
    const std::vector<std::string> times{"2021-08-14_18:00:00", "2021-08-14_18:10:00"};
    const NestedDomain outer;
    outer.write(folder / "wrfout_d01", times);
    outer.nest(2, 4, 3, 15, 12).write(folder / "wrfout_d02", {times[1]});
    const std::string run = "'" + folder.path().string() + "'";
    const Outcome outcome = runProgram("info " + run);
    CHECK(outcome.status == 0);
    CHECK(contains(outcome.out, "Domains  d01: 12 x 10 x 5 cells of 3 km"));
    CHECK(contains(outcome.out,
                   "d02: 15 x 12 x 5 cells of 1 km, from x 9 km, y 6 km, at 1 of 2 times"));
    CHECK(contains(outcome.out, "Shown    d02 (1 km) within d01 (3 km), shown at 1 km."));
    const auto json = nlohmann::json::parse(runProgram("info --json " + run).out);
    REQUIRE(json.at("domains").size() == 2);
    CHECK(json.at("domains")[0].at("name") == "d01");
    const auto& nest = json.at("domains")[1];
    CHECK(nest.at("name") == "d02");
    CHECK(nest.at("ratio") == 3);
    REQUIRE(nest.at("south_west_km").size() == 2);
    CHECK(nest.at("south_west_km")[0].is_null());
    CHECK(nest.at("south_west_km")[1][0].get<double>() == doctest::Approx(9.0));
    const Outcome image = runProgram("render " + run + " --time 1 --size 32x18 -o '" +
                                     (folder / "a.png").string() + "'");
    CHECK(image.status == 0);
    CHECK(contains(image.err, "d02 (1 km) within d01 (3 km), shown at 1 km."));
}
