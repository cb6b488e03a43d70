// ensemble_test.cpp: runs of one grid as members, on the command line.
#include <doctest/doctest.h>
#include <netcdf.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/image_io/png.h"
#include "tests/cli/program.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

namespace {

/// A run of the map of `place_test`, with so much cloud water in the columns with x below `width`.
WrfSpec specOf(float ratio, int width) {
    WrfSpec spec;
    spec.mapProjection = 1;
    spec.attributes = {{"TRUELAT1", 30.0}, {"TRUELAT2", 60.0}, {"STAND_LON", -97.0},
                       {"CEN_LAT", 35.0},  {"CEN_LON", -97.0}, {"MOAD_CEN_LAT", 35.0},
                       {"POLE_LAT", 90.0}, {"POLE_LON", 0.0}};
    spec.times = {"2024-05-06_21:00:00", "2024-05-06_21:10:00"};
    spec.fields["QCLOUD"] = [=](int x, int, int z, int) {
        return z == 2 && x < width ? ratio : 0.0f;
    };
    spec.fields["QRAIN"] = everywhere(0.0f);
    return spec;
}

/// Three members in folders mem01 to mem03, of which the last lacks the second time.
void writeMembers(const TemporaryFolder& folder) {
    for (int member = 1; member <= 3; ++member) {
        const auto run = folder / ("mem0" + std::to_string(member));
        std::filesystem::create_directories(run);
        WrfSpec spec = specOf(1e-3f * static_cast<float>(member), member + 1);
        if (member == 3) spec.times.resize(1);
        writeWrf(run / "wrfout_d01_2024-05-06_21:00:00", spec);
    }
}

std::string inQuotes(const std::filesystem::path& path) {
    return "'" + path.string() + "'";
}

struct NetcdfMap {
    std::vector<float> values;
    std::string units, longName;
    double threshold = 0.0;
    double latitude = 0.0;  ///< of the first column
};

NetcdfMap readMap(const std::filesystem::path& path, const char* name) {
    NetcdfMap map;
    int file = 0, variable = 0;
    REQUIRE(nc_open(path.c_str(), NC_NOWRITE, &file) == NC_NOERR);
    REQUIRE(nc_inq_varid(file, name, &variable) == NC_NOERR);
    map.values.resize(12);
    CHECK(nc_get_var_float(file, variable, map.values.data()) == NC_NOERR);
    const auto text = [&](const char* attribute) {
        std::size_t length = 0;
        REQUIRE(nc_inq_attlen(file, variable, attribute, &length) == NC_NOERR);
        std::string value(length, ' ');
        nc_get_att_text(file, variable, attribute, value.data());
        return value;
    };
    map.units = text("units");
    map.longName = text("long_name");
    nc_get_att_double(file, variable, "threshold", &map.threshold);
    std::vector<double> latitudes(12);
    REQUIRE(nc_inq_varid(file, "latitude", &variable) == NC_NOERR);
    CHECK(nc_get_var_double(file, variable, latitudes.data()) == NC_NOERR);
    map.latitude = latitudes.front();
    nc_close(file);
    return map;
}

}  // namespace

TEST_CASE("ensemble writes the share of members above a threshold, as NetCDF with its place") {
    const TemporaryFolder folder;
    writeMembers(folder);
    const auto file = folder / "map.nc";
    const Outcome outcome = runProgram("ensemble " + inQuotes(folder.path()) +
                                       " --time 0 --exceeds 0.001 -o " + inQuotes(file));
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(contains(outcome.out, "Members  3: mem01, mem02, mem03"));
    CHECK(contains(outcome.out, "in all of them       50 %"));
    CHECK(contains(outcome.err, "not to scale"));
    const NetcdfMap map = readMap(file, "probability");
    const float third = 1.0f / 3.0f;
    for (int y = 0; y < 3; ++y) {
        const auto row = static_cast<std::size_t>(4 * y);
        CHECK(map.values[row] == 1.0f);
        CHECK(map.values[row + 1] == 1.0f);
        CHECK(map.values[row + 2] == 2.0f * third);
        CHECK(map.values[row + 3] == third);
    }
    CHECK(map.units == "1");
    CHECK(map.longName == "Probability of optical depth > 0.001");
    CHECK(map.threshold == 0.001);
    CHECK(map.latitude == doctest::Approx(34.98).epsilon(1e-3));
}

TEST_CASE("ensemble states members without the time, and writes tables and images") {
    const TemporaryFolder folder;
    writeMembers(folder);
    const Outcome table = runProgram("ensemble " + inQuotes(folder.path()) + " --time 1 -o " +
                                     inQuotes(folder / "map.csv"));
    CAPTURE(table.err);
    REQUIRE(table.status == 0);
    CHECK(contains(table.out, "Without  mem03: no such time"));
    CHECK(contains(table.err, "mem03 lacks 1 of 2 times: 2024-05-06_21:10:00."));
    const std::string text = readText(folder / "map.csv");
    CHECK(contains(text, "x_m,y_m,latitude_deg,longitude_deg,probability,"));
    CHECK(std::ranges::count(text, '\n') == 3 + 12);
    const Outcome image = runProgram("ensemble " + inQuotes(folder.path()) +
                                     " --time 0 --show mean -o " + inQuotes(folder / "map.png"));
    REQUIRE(image.status == 0);
    const neph::Image8 drawn = neph::readPng(folder / "map.png");
    CHECK(drawn.size.x > 400);
    // More members have cloud in the west of the map than in the east.
    const auto brightness = [&](int x) {
        const auto at = static_cast<std::size_t>(4 * (drawn.size.x * (drawn.size.y / 2) + x));
        return drawn.rgba[at] + drawn.rgba[at + 1] + drawn.rgba[at + 2];
    };
    CHECK(brightness(120) > brightness(480));
}

TEST_CASE("runs of other grids, single runs and unknown members are refused") {
    const TemporaryFolder folder;
    writeMembers(folder);
    WrfSpec other = specOf(1e-3f, 2);
    other.dx = 500.0f;
    writeWrf(folder / "other", other);
    const std::string first = inQuotes(folder / "mem01");
    const Outcome grids = runProgram("info --members " + first + " " + inQuotes(folder / "other"));
    CHECK(grids.status == 1);
    CHECK(contains(grids.err, "grid of member other is not that of mem01"));
    CHECK(contains(grids.err, "4 x 3 columns of 500 m x 2 km"));
    CHECK(contains(grids.err, "4 x 3 columns of 1 km x 2 km"));
    CHECK(contains(runProgram("ensemble " + first + "/wrf*").err, "two members at least"));
    const std::string all = "--members " + inQuotes(folder.path());
    const Outcome name = runProgram("render " + all + " --member 7");
    CHECK(name.status == 2);
    CHECK(contains(name.err, "expected: mem01, mem02, mem03 or mean"));
    CHECK(contains(runProgram("render --member 1 " + first).err, "are a single run"));
    CHECK(contains(runProgram("render " + first + " " + all).err, "there are --members as well"));
    const Outcome window = runProgram("--member 2 " + first);
    CHECK(window.status == 2);
    CHECK(contains(window.err, "there is no ensemble"));
    const Outcome time = runProgram("render " + all + " --member mem03 --time 1");
    CHECK(time.status == 1);
    CHECK(contains(time.err, "member mem03: has no time 2024-05-06_21:10:00"));
}

TEST_CASE("info lists the members and their times") {
    const TemporaryFolder folder;
    writeMembers(folder);
    const std::string all = "info --members " + inQuotes(folder.path());
    CHECK(contains(runProgram(all).out, "mem03: 1 time, 2024-05-06_21:00:00, "));
    const auto json = nlohmann::json::parse(runProgram(all + " --json").out);
    REQUIRE(json.at("members").size() == 3);
    CHECK(json.at("members")[1].at("name") == "mem02");
    CHECK(json.at("members")[0].at("times").size() == 2);
    CHECK(json.at("members")[2].at("times").size() == 1);
    CHECK(json.at("times").size() == 2);
}

TEST_CASE("render draws a member, the mean, and one beside the other") {
    const TemporaryFolder folder;
    writeMembers(folder);
    const std::string all =
        "render --members " + inQuotes(folder.path()) + " --time 0 --size 48x27 --samples 1 -o ";
    for (const char* member : {"mem01", "3", "mean"}) {
        const auto file = folder / (std::string(member) + ".png");
        const Outcome outcome =
            runProgram(all + inQuotes(file) + " --member " + std::string(member));
        CAPTURE(outcome.err);
        REQUIRE(outcome.status == 0);
    }
    CHECK(neph::readPng(folder / "mem01.png").rgba != neph::readPng(folder / "3.png").rgba);
    CHECK(neph::readPng(folder / "mem01.png").rgba != neph::readPng(folder / "mean.png").rgba);
    const Outcome beside =
        runProgram(all + inQuotes(folder / "ab.png") + " --member 1 --member-b mean");
    REQUIRE(beside.status == 0);
    CHECK(contains(beside.err, "mean of 3 members is smoother"));
    std::string data;
    for (const auto& [key, text] : neph::readPngMetadata(folder / "ab.png")) {
        if (key == "nephoscope.data" || key == "nephoscope.b.data") data += text;
    }
    CHECK(contains(data, "member mem01 of 3"));
    CHECK(contains(data, "mean of 3 members"));
}

TEST_CASE("compare draws two members of an ensemble and tells how far they are apart") {
    const TemporaryFolder folder;
    writeMembers(folder);
    const std::string all = "compare --members " + inQuotes(folder.path()) +
                            " --time 0 --size 48x27 --set view.light_voxels=1000 ";
    const Outcome outcome = runProgram(all + "--member 1 --with-member mean --json");
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json.at("reference").at("name") == "mean");
    REQUIRE(json.at("images").size() == 1);
    CHECK(json.at("images")[0].at("name") == "mem01");
    CHECK(json.at("images")[0].at("rel_rmse") > 0.0);
    const Outcome same = runProgram(all + "--member 1 --with-member mem01 --json");
    REQUIRE(same.status == 0);
    CHECK(nlohmann::json::parse(same.out).at("images")[0].at("rel_rmse") == 0.0);
    CHECK(runProgram(all + "--engine march,slicing --with-member 2").status == 2);
    CHECK(contains(runProgram("compare --with-member 2").err, "there is no ensemble"));
}
