// view_test.cpp: images from a side and from a place, told on the command line.
#include <doctest/doctest.h>

#include "app/image_io/png.h"
#include "tests/cli/program.h"

using namespace neph;

namespace {

// Light that needs no solution: these tests are about cameras.
const std::string kSmall =
    "render cumulus --set light.transport=low_albedo --quality 0.25 --samples 1 --size 24x16 ";

std::string cameraOf(const std::string& arguments) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "a.png";
    const Outcome outcome = runProgram(kSmall + arguments + " --out '" + file.string() + "'");
    CHECK_MESSAGE(outcome.status == 0, outcome.err);
    if (outcome.status != 0) return {};
    for (const auto& [key, text] : readPngMetadata(file)) {
        if (key == "nephoscope.camera") return text;
    }
    return {};
}

}  // namespace

TEST_CASE("An image is taken from a side, or from a place, as the command line says") {
    CHECK(contains(cameraOf("--view plan"), "azimuth 180 elevation 89.9 fov"));
    CHECK(contains(cameraOf("--observer 2,1,2,45,10,50"), "azimuth 225 elevation -10 fov 50"));
}

TEST_CASE("Where no camera is asked for, all cloud is in the image, as in the window") {
    const std::string fit = cameraOf("--view fit");
    const std::string preset = cameraOf("--camera default");
    REQUIRE(!fit.empty());
    CHECK(contains(preset, "distance 0.55 azimuth 246"));  // presets/default.json
    CHECK(fit != preset);
    CHECK(cameraOf("") == fit);
    CHECK(cameraOf("--set view.exposure=1") == fit);
    CHECK(cameraOf("--preset default --parts light,view") == fit);
    CHECK(cameraOf("--preset default") == preset);
    CHECK(contains(cameraOf("--preset fig01-cumulus"), "distance 1.9 azimuth 205"));
}

TEST_CASE("A preset without a camera leaves it to the data") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "bright.json";
    std::ofstream(file) << R"({"type": "nephoscope-look", "version": 1,
                              "look": {"view.exposure": 1.5}})";
    const std::string named = "--preset '" + file.string() + "'";
    const std::string camera = cameraOf(named);
    CHECK(contains(camera, "elevation 12 fov 40"));  // the direction of no preset
    CHECK(camera == cameraOf(named + " --view fit"));
}

TEST_CASE("A view that is not known and an observer that cannot be are bad usage, and say why") {
    const auto refusal = [](const std::string& arguments) {
        const Outcome outcome = runProgram(kSmall + arguments);
        CHECK(outcome.status == 2);
        return outcome.err;
    };
    CHECK(contains(refusal("--view nort"), "did you mean north?"));
    CHECK(contains(refusal("--observer 1,2,3"), "five or six numbers"));
    CHECK(contains(refusal("--observer 1,2,3,4,95"), "elevation, degrees is not between -90"));
    CHECK(contains(refusal("--observer 1,2,x,4,5"), "height, m cannot be read"));
    CHECK(contains(refusal("--observer 1,2,3,4,5 --view plan"), "give one of the two"));
    CHECK(contains(refusal("--view plan --path none.json"), "camera path as well"));
    CHECK(contains(refusal("--observer 9000,0,2,90,0"), "too far from the domain"));
}
