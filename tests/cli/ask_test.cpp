// ask_test.cpp: `nephoscope probe`, `profile`, `section` and `series`, run as a user runs them.
//
// Values of the bundled storm were computed from its files by numpy, in double precision.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "app/image_io/png.h"
#include "tests/cli/program.h"

namespace {

const std::string kHour =
    "'" NEPH_TEST_SOURCE_DIR "/samples/supercell/wrfout_d01_0001-01-01_01:00:00'";

}  // namespace

TEST_CASE("probe tells what is in a column, for people and as JSON") {
    const Outcome text = runProgram("probe " + kHour + " --at 55.2,28.7");
    CHECK(text.status == 0);
    for (const char* part : {"x 55.50, y 28.50 km (column 55, 28)", "Graupel, g/kg", "CAPE J/kg",
                             "most unstable", "not known: wind_speed: they have no wind along x"}) {
        CAPTURE(part);
        CHECK(contains(text.out, part));
    }
    const Outcome outcome = runProgram("probe --json " + kHour + " --at 55.2,28.7");
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json.at("height_m")[20].get<double>() == doctest::Approx(7205.387).epsilon(1e-6));
    const auto value = [&](const char* id) {
        return json.at("profiles").at(id).at("values")[20].get<double>();
    };
    CHECK(value("rh") == doctest::Approx(42.4185).epsilon(1e-4));
    CHECK(value("temperature") == doctest::Approx(-21.9367).epsilon(1e-4));
}

TEST_CASE("series has maxima, masses, top, base and cover as numpy finds them") {
    const TemporaryFolder folder;
    const std::string file = (folder / "series.csv").string();
    const Outcome outcome = runProgram("series " + kHour + " -o '" + file + "'");
    REQUIRE(outcome.status == 0);
    CHECK(contains(outcome.out, "wrote " + file));
    const std::string csv = readText(file);
    for (const char* part : {"# Model: WRF V4.2.2", "14.22119,38500,68500,5184.148,1.226222e+10",
                             "15149.83,1123.28,"
                             "0.2715909"}) {
        CAPTURE(part);
        CHECK(contains(csv, part));
    }
}

TEST_CASE("section and profile write plots and tables") {
    const TemporaryFolder folder;
    const std::string png = (folder / "section.png").string(),
                      svg = (folder / "section.svg").string(),
                      csv = (folder / "profile.csv").string();
    const Outcome section =
        runProgram("section " + kHour + " --from 20,60 --to 80,60 --show graupel --contours theta" +
                   " --size 400x300 -o '" + png + "' -o '" + svg + "'");
    CHECK(section.err == "");
    CHECK(section.status == 0);
    CHECK(neph::readPng(png).size == glm::ivec2(800, 600));
    const std::string drawing = readText(svg);
    CHECK(contains(drawing, "<svg"));
    CHECK(contains(drawing, "<desc>Software: Nephoscope"));
    const Outcome profile = runProgram("profile " + kHour + " --at 55,28 -o '" + csv + "'");
    CHECK(profile.status == 0);
    CHECK(contains(readText(csv), "height [m],cloud [g/kg]"));
}

TEST_CASE("What cannot be asked is said with what can") {
    const Outcome place = runProgram("probe " + kHour + " --at 55");
    CHECK(place.status == 2);
    CHECK(contains(place.err, "35.2N,97.4W"));
    const Outcome outside = runProgram("probe " + kHour + " --at 155,20");
    CHECK(outside.status == 1);
    CHECK(contains(outside.err, "0 to 110, 0 to 120 km"));
    const Outcome wind = runProgram("section " + kHour + " --height 3000 --show wind_speed");
    CHECK(wind.status == 1);
    CHECK(contains(wind.err, "they have no wind along x"));
    const Outcome kind = runProgram("section " + kHour + " --height 3000 -o w.pdf");
    CHECK(kind.status == 2);
    CHECK(contains(kind.err, ".svg, .png or .csv"));
    const Outcome line = runProgram("section " + kHour);
    CHECK(line.status == 2);
    CHECK(contains(line.err, "--from PLACE --to PLACE"));
}
