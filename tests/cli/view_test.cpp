// view_test.cpp: images from a side and from a place, told on the command line.
#include <doctest/doctest.h>

#include <cstdio>
#include <glm/glm.hpp>

#include "app/image_io/png.h"
#include "tests/cli/program.h"
#include "tests/readers/raw_maker.h"
#include "tests/temporary_folder.h"

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

TEST_CASE("A camera that is fixed to the ground falls back as the grid moves on") {
    // One cell of fog at 540 and 720 s, in a grid of 0.5 km x 0.8 km that moves at 1 and -2 m/s.
    const TemporaryFolder folder;
    const std::string data = "'" + writeGrads(folder.path(), {}).string() + "'";
    writeText(folder / "namelist.input", " imove = 1,\n umove = 1.0,\n vmove = -2.0,\n");
    const auto targetOf = [&](const std::string& more, int time) {
        const std::filesystem::path file = folder / "a.png";
        const Outcome outcome =
            runProgram("render " + data + " --set light.transport=low_albedo --quality 0.25 " +
                       "--samples 1 --size 24x16 --camera default --time 0:1 " + more + " --out '" +
                       file.string() + "'");
        CHECK_MESSAGE(outcome.status == 0, outcome.err);
        for (const auto& entry :
             readPngMetadata(folder / ("a_000" + std::to_string(time) + ".png"))) {
            if (entry.first != "nephoscope.camera") continue;
            glm::dvec3 target;
            CHECK(std::sscanf(entry.second.c_str(), "target %lf,%lf,%lf", &target.x, &target.y,
                              &target.z) == 3);
            return target;
        }
        return glm::dvec3(0.0);
    };
    const glm::dvec3 follows = targetOf("", 1);
    CHECK(follows == targetOf("", 0));
    CHECK(targetOf("--fix-camera", 0) == follows);
    const glm::dvec3 fixed = targetOf("--fix-camera", 1);
    // 180 m eastwards of 500 m, 360 m southwards of 800 m.
    CHECK(fixed.x == doctest::Approx(follows.x - 180.0 / 500.0).epsilon(1e-5));
    CHECK(fixed.y == doctest::Approx(follows.y + 360.0 / 800.0).epsilon(1e-5));
    CHECK(fixed.z == follows.z);
}
