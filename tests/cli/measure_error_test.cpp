// measure_error_test.cpp: `render --measure-error` states what it measured, in words and in files.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/image_io/exr.h"
#include "app/image_io/png.h"
#include "tests/cli/program.h"

using namespace neph;

namespace {

const std::string kRenderStorm =
    "render " NEPH_TEST_SOURCE_DIR "/samples/supercell/wrfout_d01_0001-01-01_00:30:00 ";

std::string metadataText(const Metadata& metadata, const std::string& wanted) {
    for (const auto& [key, text] : metadata) {
        if (key == wanted) return text;
    }
    return {};
}

}  // namespace

TEST_CASE("The error of an image is printed, and kept in its file with what it was measured by") {
    const TemporaryFolder folder;
    const std::string file = (folder / "a.exr").string();
    const Outcome outcome = runProgram(
        kRenderStorm + "--size 16x9 --set mode.noise=false --profile --measure-error 0.1 --out " +
        file);
    REQUIRE(outcome.status == 0);
    CHECK_MESSAGE(contains(outcome.err, "\n  error           "), outcome.err);
    CHECK_MESSAGE(contains(outcome.err, "16 x 9 px against "), outcome.err);
    Metadata metadata;
    readExr(file, &metadata);
    const auto json = nlohmann::json::parse(metadataText(metadata, "nephoscope.error"));
    CHECK(json.at("width") == 16);
    CHECK(json.at("height") == 9);
    CHECK(json.at("paths").get<int>() >= 4);
    CHECK(json.at("rel_rmse").get<double>() >= 0.0);
    CHECK(json.at("rel_rmse_sigma").get<double>() > 0.0);
    CHECK(std::abs(json.at("bias").get<double>()) < 1.0);
}

TEST_CASE("Without a measurement a profile has the known error of a mode, and a file has none") {
    const TemporaryFolder folder;
    const std::string file = (folder / "a.png").string();
    const Outcome known = runProgram(
        kRenderStorm + "--size 16x9 --profile --set light.transport=translucent --out " + file);
    CHECK_MESSAGE(contains(known.err, "  error           forward scattering alone: "), known.err);
    CHECK(metadataText(readPngMetadata(file), "nephoscope.error").empty());
}

TEST_CASE("Where the reference is black an image is written, with a warning in place of an error") {
    const TemporaryFolder folder;
    const std::string file = (folder / "a.png").string();
    const Outcome outcome = runProgram(
        kRenderStorm +
        "--size 8x4 --measure-error 0.1 --set mode.noise=false --set sun.intensity=0 --set "
        "sky.intensity=0 --set ground.visible=false --out " +
        file);
    REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
    CHECK_MESSAGE(contains(outcome.err, "warning: the error cannot be measured"), outcome.err);
    CHECK_FALSE(contains(outcome.err, "error now"));
    CHECK(metadataText(readPngMetadata(file), "nephoscope.error").empty());
}
