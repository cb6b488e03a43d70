// profile_test.cpp: what `render --profile` says of an image, as numbers that must agree.
#include <doctest/doctest.h>

#include <map>
#include <sstream>

#include "tests/cli/program.h"

namespace {

const std::string kStormFile =
    NEPH_TEST_SOURCE_DIR "/samples/supercell/wrfout_d01_0001-01-01_00:30:00";

/// The lines of a profile: what follows each label.
std::map<std::string, std::string> profileOf(const std::string& options) {
    const TemporaryFolder folder;
    const Outcome outcome = runProgram("render " + kStormFile + " --size 64x48 --profile " +
                                       options + " --out " + (folder / "a.png").string());
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.empty());
    std::map<std::string, std::string> lines;
    std::istringstream text(outcome.err);
    for (std::string line; std::getline(text, line);) {
        if (!line.starts_with("  ")) continue;
        const std::size_t end = line.find("  ", line.find_first_not_of(' '));
        REQUIRE(end != std::string::npos);
        const std::size_t value = line.find_first_not_of(' ', end);
        lines[line.substr(line.find_first_not_of(' '), end - line.find_first_not_of(' '))] =
            line.substr(value);
    }
    return lines;
}

/// The number at the head of a line in its unit, or in ones where a count has a prefix.
double number(const std::string& text) {
    std::istringstream stream(text);
    double value = -1.0;
    std::string unit;
    stream >> value >> unit;
    return value * (unit == "k" ? 1e3 : unit == "M" ? 1e6 : 1.0);
}

}  // namespace

TEST_CASE("A profile of the march: passes within the frame, samples, memory by part") {
    auto lines = profileOf("--engine march --samples 1");
    CHECK(lines["engine"] == "March");
    CHECK(lines["image"].starts_with("64 x 48 px"));
    CHECK(lines["redone"] == "medium > light > eye > resolve");
    double passesMs = 0.0;
    for (const char* pass : {"bake medium", "light", "light to medium", "eye", "resolve"}) {
        CAPTURE(pass);
        REQUIRE(lines.count(pass) == 1);
        CHECK(number(lines[pass]) >= 0.0);
        passesMs += number(lines[pass]);
    }
    CHECK(passesMs > 0.0);
    CHECK(passesMs < 1.01 * number(lines["frame"]) + 0.1);  // each rounded to 0.01 ms
    const double rays = number(lines["rays"]);
    CHECK(rays > 0.0);
    CHECK(rays <= 64.0 * 48.0 + 5.0);  // rounded to tens
    CHECK(number(lines["samples"]) > rays);
    CHECK(number(lines["terminated"]) <= rays);
    const double memory = number(lines["GPU memory"]);
    double parts = 0.0;
    for (const char* part : {"species", "medium", "light", "noise", "air", "images"}) {
        parts += number(lines[part]);
    }
    CHECK(memory > 0.0);
    CHECK(parts == doctest::Approx(memory).epsilon(0.3 / memory));  // each rounded to 0.1 MiB
}

TEST_CASE("Samples of an image are profiled as one") {
    auto one = profileOf("--engine march --samples 1"),
         four = profileOf("--engine march --samples 4");
    CHECK(number(four["rays"]) == doctest::Approx(4.0 * number(one["rays"])).epsilon(0.01));
    CHECK(number(four["samples"]) == doctest::Approx(4.0 * number(one["samples"])).epsilon(0.2));
}

TEST_CASE("A profile of slicing has its passes and no counts, which it does not keep") {
    auto lines = profileOf("--engine slicing --planes 32");
    CHECK(lines["engine"] == "Half-angle slicing");
    CHECK(lines["image"].find("32 planes") != std::string::npos);
    for (const char* pass : {"bake medium", "light", "eye", "background", "resolve"}) {
        CHECK(lines.count(pass) == 1);
    }
    CHECK(lines.count("rays") == 0);
}

TEST_CASE("Without --profile nothing is said of passes") {
    const TemporaryFolder folder;
    const Outcome outcome =
        runProgram("render " + kStormFile + " --size 64x48 --out " + (folder / "a.png").string());
    REQUIRE(outcome.status == 0);
    CHECK_FALSE(contains(outcome.err, " ms\n"));
}
