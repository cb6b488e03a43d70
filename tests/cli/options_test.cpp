// options_test.cpp: every option is heeded or refused, wherever it stands and with whatever else it
// is given: nothing that was typed is dropped in silence.
#include <doctest/doctest.h>

#include <vector>

#include "app/image_io/png.h"
#include "core/session/session_file.h"
#include "tests/cli/program.h"

using namespace neph;

namespace {

struct Case {
    std::string arguments;
    const char* says;
};

void checkRefused(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
        CAPTURE(c.arguments);
        const Outcome outcome = runProgram(c.arguments);
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.starts_with("error: "));
        CHECK_MESSAGE(contains(outcome.err, c.says), outcome.err);
    }
}

}  // namespace

TEST_CASE("What stands before a command is refused with the place where it belongs") {
    checkRefused({{"--reader fog.so info bank.fog", "expected: nephoscope info --reader"},
                  {"--reader=fog.so info bank.fog", "expected: nephoscope info --reader"},
                  {"--session s.json render", "expected: nephoscope render --session"},
                  {"--set sun.elevation=5 compare", "expected: nephoscope compare --set"},
                  {"--preset default thumbnails", "expected: nephoscope thumbnails --preset"},
                  {"--reader fog.so bench", "expected: nephoscope bench --reader"},
                  {"--reader fog.so readers", "expected: nephoscope readers --reader"},
                  {"bank.fog info", "a file of the name info is ./info"},
                  {"--size 3x3 render", "expected: nephoscope render --size"},
                  {"--script s keys", "before the command keys, which does not take it"},
                  {"--time 1 validate", "before the command validate, which does not take it"},
                  {"--preset default presets list", "list, which does not take it"},
                  {"presets --title a save x", "expected: nephoscope presets save --title"}});
}

TEST_CASE("An option that a command does not take is refused with those that take it") {
    checkRefused({{"--size 3x3", "taken by nephoscope render"},
                  {"render --script s", "taken by the window"},
                  {"render --json", "taken by nephoscope compare"},
                  {"compare --quality 2", "taken by nephoscope render"},
                  {"info --preset default", "taken by the window, nephoscope render"},
                  {"thumbnails --time 1", "taken by the window"},
                  {"presets --json", "nephoscope presets does not take this"},
                  {"presets show default --set a=1", "taken by the window"},
                  {"presets list extra", "nephoscope presets list does not take this"},
                  {"readers extra", "nephoscope readers does not take this"},
                  {"keys --json", "nephoscope keys does not take this"},
                  {"bench --quality 1", "taken by nephoscope render"},
                  {"validate --reader x.so", "taken by the window"}});
}

TEST_CASE("What is given twice is refused, flags and lists apart") {
    checkRefused({{"render --size 3x3 --size 4x4", "found: 3x3, 4x4"},
                  {"info --time 0 --time 1", "more than once"},
                  {"--camera default --camera fig01-cumulus", "more than once"},
                  {"presets save a --title b --title c", "more than once"},
                  {"render --set sun.elevation=5 --set sun.elevation=6", "found: 5 and 6"},
                  {"render --set view.engine=march --engine slicing", "view.engine is set twice"},
                  {"compare --engine march:view.quality=1:view.quality=2,slicing", "set twice"},
                  {"compare --engine march,slicing --set view.engine=march", "names the engines"}});
    CHECK(runProgram("info cumulus --json --json").status == 0);
}

TEST_CASE("Options of render without meaning for the output, the engine or the path are refused") {
    checkRefused(
        {{"render --fps 10", "--out FILE.mp4"},
         {"render --path p.json --frames 3 --fps 10", "--frames says how many"},
         {"render --frames 3", "there is no camera path"},
         {"render --path p.json --along-path --session s.json", "give one of the two"},
         {"render --format float", "--out FILE.exr"},
         {"render --out a.mp4 --transparent", "a video is opaque"},
         {"render --split 0.5", "--preset-b"},
         {"render --slot 1", "--session FILE"},
         {"render --compare", "--session FILE"},
         {"render --along-path", "--session FILE"},
         {"render --session s.json --compare --slot 2", "--compare shows both slots"},
         {"render --parts light", "--preset NAME"},
         {"render --time-b 0:1", "--time-b 0:1"},
         {"render --denoise", "expected: reference"},
         {"render --engine reference --denoise --samples 1", "needs two samples"},
         {"render --engine reference --denoise --supersample 2", "one ray per pixel"},
         {"render --engine reference --denoise --time-b 0", "two side by side"},
         {"render cumulus --engine reference --denoise --size 20000x2", "seams would show"},
         {"compare --engine march,reference --denoise", "taken by nephoscope render"},
         {"render --planes 64", "expected: slicing"},
         {"render --error 5", "expected: reference"},
         {"render --engine reference --error 51", "from 0.05 to 50 %"},
         {"render --seed 1", "expected: reference"},
         {"render --engine slicing --quality 2", "expected: march"},
         {"render --engine slicing --samples 2", "expected: march, reference"}});
}

TEST_CASE("An option that acts on one of two sides is no fault") {
    const TemporaryFolder folder;
    std::ofstream(folder / "slicing.json")
        << R"({"type": "nephoscope-look", "version": 1, "look": {"view.engine": "slicing"}})";
    const Outcome outcome = runProgram(
        "render cumulus --size 8x8 --quality 0.25 --samples 1 --planes 16 --preset-b '" +
        (folder / "slicing.json").string() + "' --out '" + (folder / "ab.png").string() + "'");
    CHECK_MESSAGE(outcome.status == 0, outcome.err);
}

TEST_CASE("An error is typed in percent, and kept in the metadata as a share") {
    const TemporaryFolder folder;
    const std::string file = (folder / "a.png").string();
    const Outcome outcome = runProgram(
        "render cumulus --size 4x4 --engine reference --error 50 --set reference.air=tables "
        "--out '" +
        file + "'");
    REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
    for (const auto& [key, text] : readPngMetadata(file)) {
        if (key == "nephoscope.sampling") CHECK(contains(text, "view.target_error=0.5"));
    }
}

TEST_CASE("A path that does not go through the times takes one of them") {
    const TemporaryFolder folder;
    std::ofstream(folder / "p.json")
        << R"({"type": "nephoscope-camera-path", "version": 1, "with_time": false,
               "keys": [{"at_s": 0, "camera": {}}, {"at_s": 1, "camera": {}}]})";
    checkRefused({{"render cumulus --time all --path '" + (folder / "p.json").string() + "'",
                   "does not go through the times"}});
}

TEST_CASE("Options of compare without meaning for images, or for engines, are refused") {
    checkRefused({{"compare a.png b.png --preset default", "two images are compared"},
                  {"compare a.png b.png --size 3x3", "two images are compared"},
                  {"compare a.png b.png --samples 3", "two images are compared"},
                  {"compare a.png b.png --signed", "--error-image"},
                  {"compare a.png b.png --error-to 5", "--error-image"},
                  {"compare --engine march,slicing --signed", "--out FOLDER"},
                  {"compare --engine march,slicing --flip-image a.png", "--out FOLDER"},
                  {"compare --engine march,slicing --time all", "more than the one time"},
                  {"compare --engine march,slicing --samples 4", "expected: reference"},
                  {"compare --engine march,march --planes 32", "expected: slicing"}});
}

TEST_CASE("Options of the other commands without meaning are refused") {
    checkRefused({{"thumbnails --size 3x3", "--out FOLDER"},
                  {"presets describe mine", "--title TEXT"},
                  {"validate --json --only no-such-trial", "leaves nothing to measure"}});
}

TEST_CASE("The window refuses what it would drop") {
    const TemporaryFolder folder;
    SessionState state;
    state.slots.resize(1);
    const std::string session = (folder / "s.nephoscope.json").string();
    saveSession(session, state);
    checkRefused({{"--time 0:1", "more than the one time"},
                  {"--parts light", "--preset NAME"},
                  {"--session '" + session + "' storm", "give one of the two"},
                  {"--session '" + session + "' --preset default", "render --session"},
                  {"'" + session + "' --time 1", "render --session"}});
}
