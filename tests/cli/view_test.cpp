// view_test.cpp: images from a side and from a place, told on the command line.
#include <doctest/doctest.h>

#include "app/image_io/png.h"
#include "tests/cli/program.h"

using namespace neph;

namespace {

const std::string kSmall = "render cumulus --quality 0.25 --samples 1 --size 24x16 ";

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
