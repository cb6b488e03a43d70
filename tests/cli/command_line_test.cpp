// command_line_test.cpp: the commands as a user types them: exit status, output, files.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "app/image_io/exr.h"
#include "app/image_io/png.h"
#include "core/look/sun.h"
#include "tests/cli/program.h"
#include "tests/readers/wrf_maker.h"

using namespace neph;

namespace {

const std::string kSource = NEPH_TEST_SOURCE_DIR;
const std::string kStormFile = kSource + "/samples/supercell/wrfout_d01_0001-01-01_00:30:00";
// Small and coarse: these tests are about files and words, not about images.
const std::string kQuick = " --size 48x32 --quality 0.25 --samples 1 ";
// With light that needs no solution.
const std::string kQuickest = kQuick + "--set light.transport=low_albedo ";

std::string textOf(const Metadata& metadata, const std::string& key) {
    for (const auto& [name, text] : metadata) {
        if (name == key) return text;
    }
    return {};
}

}  // namespace

TEST_CASE("Help shows examples and every command, the version is one line, both succeed") {
    const Outcome help = runProgram("--help");
    CHECK(help.status == 0);
    for (const char* word : {"Examples:", "render", "info", "presets", "readers", "bench"}) {
        CHECK(contains(help.out, word));
    }
    const Outcome version = runProgram("--version");
    CHECK(version.status == 0);
    CHECK(version.out.starts_with("nephoscope "));
}

TEST_CASE("Bad usage exits with 2 and says what would be right") {
    struct Case {
        const char* arguments;
        const char* says;
    };
    for (const Case& c : {Case{"render --no-such-option", "--no-such-option"},
                          Case{"render --plane 64", "did you mean --planes?"},
                          Case{"--tiem 1", "--time?"},
                          Case{"render --verbose", "nephoscope render --help"},
                          Case{"rendr", "render?"},
                          Case{"render --set cloud.mixing_scal=1", "cloud.mixing_scale?"},
                          Case{"render --set cloud.mixing_scale=200", "from 0 to 100"},
                          Case{"render --set cloud.mixing_scale", "id=value"},
                          Case{"render --size 640", "WxH"},
                          Case{"render --size 0x10", "WxH"},
                          Case{"render --size 99999x10", "WxH"},
                          Case{"render --planes 1", "from 16 to 2048"},
                          Case{"render --planes 0", "from 16 to 2048"},
                          Case{"render --planes x", "--planes"},
                          Case{"render --engine warp", "one of march, slicing"},
                          Case{"render --quality 0.1", "from 0.25 to 8"},
                          Case{"render --quality fine", "--quality"},
                          Case{"render --samples 0", "from 1 to 65536"},
                          Case{"render --error 0", "from 0.05 to 50 %"},
                          Case{"render --seed x", "--seed"},
                          Case{"render --samples 1.5", "--samples"},
                          Case{"render --format double", "half or float"},
                          Case{"render --out a.jpg", ".png, .exr or .mp4"},
                          Case{"render --region 1:2", "x0:x1,y0:y1"},
                          Case{"render --region 1:2,4:3", "lower before upper"},
                          Case{"render --region 1:2,3:4,", "x0:x1,y0:y1"},
                          Case{"render --region 1:2,3:nan", "in km"},
                          Case{"render --memory much", "--memory"},
                          Case{"render --memory 120%", "50%"},
                          Case{"render --time 4", "from 0 to 3"},
                          Case{"render --time 2:1", "from 0 to 3"},
                          Case{"presets show", "PRESET"},
                          Case{"presets eat", "eat"}}) {
        CAPTURE(c.arguments);
        const Outcome outcome = runProgram(c.arguments);
        CHECK(outcome.status == 2);
        CHECK(outcome.err.starts_with("error: "));
        CHECK(contains(outcome.err, c.says));
    }
}

TEST_CASE("Bad input and failed work exit with 1 and name the file") {
    struct Case {
        std::string arguments;
        const char* says;
    };
    for (const Case& c : {Case{"render no-such-file", "no-such-file"},
                          Case{"render " + kSource + "/CMakeLists.txt", "CMakeLists.txt"},
                          Case{"render --out no/such/folder/a.png", "no/such/folder"},
                          Case{"render --out /dev/null/a.png", "no folder /dev/null"},
                          Case{"bench --json no/such/folder/a.json", "no/such/folder"},
                          Case{"render --preset no-such-preset", "no-such-preset"},
                          Case{"render --preset " + kSource + "/CMakeLists.txt", "JSON"},
                          Case{"render --camera no-such-camera", "no-such-camera"},
                          Case{"info " + kSource + "/CMakeLists.txt", "CMakeLists.txt"},
                          Case{"bench no-such-file", "no-such-file"},
                          Case{"presets check no-such-file", "no-such-file"}}) {
        CAPTURE(c.arguments);
        const Outcome outcome = runProgram(c.arguments);
        CHECK(outcome.status == 1);
        CHECK(outcome.err.starts_with("error: "));
        CHECK(contains(outcome.err, c.says));
    }
}

TEST_CASE("Without a display the workbench says what to do instead") {
    const Outcome outcome = runProgram("");
    CHECK(outcome.status == 1);
    CHECK(outcome.err.starts_with("error: "));
    CHECK(contains(outcome.err, "nephoscope render"));
}

TEST_CASE("A rendered PNG has the size asked for and says where it comes from") {
    const TemporaryFolder folder;
    const auto file = folder / "storm.png";
    const Outcome outcome = runProgram("render " + kStormFile + kQuick + "--out " + file.string());
    REQUIRE(outcome.status == 0);
    CHECK(contains(outcome.err, "wrote " + file.string()));
    CHECK(readPng(file).size == glm::ivec2(48, 32));
    const Metadata metadata = readPngMetadata(file);
    CHECK(contains(textOf(metadata, "nephoscope.data"), "wrfout_d01_0001-01-01_00:30:00"));
    CHECK(contains(textOf(metadata, "nephoscope.data"), "WRF"));
    CHECK(textOf(metadata, "nephoscope.preset") == "default");
    CHECK(contains(textOf(metadata, "nephoscope.camera"), "azimuth"));
}

TEST_CASE("Look and sampling in an image's metadata render the same image again") {
    const TemporaryFolder folder;
    const auto first = folder / "first.png", second = folder / "second.png";
    REQUIRE(runProgram("render " + kStormFile + kQuickest +
                       "--set cloud.mixing_scale=0.3 --set sun.elevation=20 --out " +
                       first.string())
                .status == 0);
    const Metadata made = readPngMetadata(first);
    std::ofstream(folder / "look.json") << textOf(made, "nephoscope.look");
    std::string sampling;
    std::istringstream assignments(textOf(made, "nephoscope.sampling"));
    for (std::string word; assignments >> word;) sampling += " --set " + word;
    CHECK(contains(sampling, "view.quality=0.25"));
    REQUIRE(runProgram("render " + kStormFile + " --size 48x32 --samples 1 --preset " +
                       (folder / "look.json").string() + sampling + " --out " + second.string())
                .status == 0);
    CHECK(readPng(first).rgba == readPng(second).rgba);
}

TEST_CASE("A sun by date is drawn as the same sun by angles, and the image says where it stood") {
    const TemporaryFolder folder;
    const auto dated = folder / "dated.png", angles = folder / "angles.png";
    WrfSpec spec;
    spec.fields["QCLOUD"] = [](int x, int y, int, int) { return x == 1 && y == 1 ? 1e-3f : 0.0f; };
    writeWrf(folder / "data", spec);
    const auto rendered = [&](const std::string& sets, const std::filesystem::path& file) {
        REQUIRE(runProgram("render '" + (folder / "data").string() +
                           "' --engine slicing --planes 16 --size 24x16 " + sets + " --out " +
                           file.string())
                    .status == 0);
        return readPngMetadata(file);
    };
    // 1 June 2024 at 22:30 UTC over Oklahoma: a sun of the late afternoon.
    const std::string sun =
        textOf(rendered("--set sun.source=date --set sun.latitude=35 --set sun.longitude=-97 "
                        "--set sun.day=153 --set sun.hour=22.5",
                        dated),
               "nephoscope.sun");
    CHECK(contains(sun, "2024-06-01T22:30:00Z, 35.00 N 97.00 W"));
    Look look;
    look.sunSource = SunSource::date;
    look.sunLatitudeDeg = 35.0f;
    look.sunLongitudeDeg = -97.0f;
    look.sunDay = 153;
    look.sunHour = 22.5f;
    const SunState state = sunStateOf(look, {});
    CHECK(state.elevationDeg > 30.0f);
    CHECK(state.azimuthDeg > 260.0f);
    rendered("--set sun.azimuth=" + std::to_string(state.azimuthDeg) +
                 " --set sun.elevation=" + std::to_string(state.elevationDeg),
             angles);
    CHECK(readPng(dated).rgba == readPng(angles).rgba);
    rendered("--set sun.azimuth=90", angles);
    CHECK(readPng(dated).rgba != readPng(angles).rgba);
}

TEST_CASE("An image says whether it is to scale, on the terminal and in its file") {
    const TemporaryFolder folder;
    const auto file = folder / "a.png";
    WrfSpec spec;
    spec.fields["QCLOUD"] = [](int x, int y, int, int) { return x == 1 && y == 1 ? 1e-3f : 0.0f; };
    writeWrf(folder / "data", spec);
    const auto rendered = [&](const std::string& sets) {
        const Outcome outcome =
            runProgram("render '" + (folder / "data").string() + "' --preset cumulus" + kQuick +
                       "--set cloud.radius_source=file --set cloud.noise_amount=1 " + sets +
                       " --out " + file.string());
        REQUIRE(outcome.status == 0);
        return std::pair(outcome.err, textOf(readPngMetadata(file), "nephoscope.scale"));
    };
    const auto thinned = rendered("--set cloud.mixing_scale=0.5");
    CHECK(thinned.second == "not to scale: cloud x0.5");
    CHECK(contains(thinned.first, "note: not to scale: cloud x0.5\n"));
    const auto whole = rendered("--set cloud.mixing_scale=1");
    CHECK(whole.second == "to scale");
    CHECK_FALSE(contains(whole.first, "to scale"));
}

TEST_CASE("An engine is chosen for one image, and the image says which, how fine and how often") {
    const TemporaryFolder folder;
    const auto file = folder / "a.png";
    const auto rendered = [&](const std::string& options) {
        const Outcome outcome = runProgram("render " + kStormFile + " --size 48x32 " + options +
                                           " --out " + file.string());
        CHECK(outcome.status == 0);
        const Metadata metadata = readPngMetadata(file);
        const auto look = nlohmann::json::parse(textOf(metadata, "nephoscope.look"))["look"];
        CHECK(contains(textOf(metadata, "nephoscope.sampling"), "view.seed=0"));
        CHECK_FALSE(look.contains("view.seed"));
        const bool half = contains(textOf(metadata, "nephoscope.sampling"), "view.quality=0.5 ");
        CHECK(half == contains(options, "--quality 0.5"));
        return std::pair(textOf(metadata, "nephoscope.renderer"), look);
    };
    const auto march = rendered("--engine march --quality 0.5 --samples 2");
    CHECK(march.first.starts_with("march, "));
    CHECK(contains(march.first, " steps, 2 samples, "));
    CHECK(march.second["view.engine"] == "march");
    const auto slicing = rendered("--engine slicing --planes 16");
    CHECK(slicing.first.starts_with("slicing, 16 planes, "));
    CHECK(slicing.second["view.engine"] == "slicing");
}

TEST_CASE("A setting changes the image") {
    const TemporaryFolder folder;
    const auto a = folder / "a.png", b = folder / "b.png";
    REQUIRE(runProgram("render " + kStormFile + kQuickest + "--out " + a.string()).status == 0);
    REQUIRE(
        runProgram("render " + kStormFile + kQuickest + "--set view.exposure=2 --out " + b.string())
            .status == 0);
    CHECK(readPng(a).rgba != readPng(b).rgba);
}

TEST_CASE("A part of the domain is rendered, and what memory does not hold is averaged") {
    const TemporaryFolder folder;
    const std::string out = "--out " + (folder / "a.png").string();
    const Outcome part =
        runProgram("render " + kStormFile + kQuickest + "--region 20:60,30:70 " + out);
    CHECK(part.status == 0);
    CHECK(contains(part.err, "x 20 to 60 km, y 30 to 70 km"));
    const Outcome coarse = runProgram("render " + kStormFile + kQuickest + "--memory 4MiB " + out);
    CHECK(coarse.status == 0);
    CHECK(contains(coarse.err, "Every 2 x 2 columns are averaged"));
    CHECK(contains(runProgram("info " + kStormFile + " --memory 4MiB").out, "2 x 2 columns"));
    const Outcome nowhere =
        runProgram("render " + kStormFile + kQuickest + "--region 900:910,1:2 " + out);
    CHECK(nowhere.status == 1);
    CHECK(contains(nowhere.err, "holds no cell"));
}

TEST_CASE("Several times are numbered by their index, in EXR as asked for") {
    const TemporaryFolder folder;
    const Outcome outcome = runProgram("render --time 1:2 --format float" + kQuickest + "--out " +
                                       (folder / "storm.exr").string());
    REQUIRE(outcome.status == 0);
    CHECK_FALSE(std::filesystem::exists(folder / "storm.exr"));
    Metadata metadata;
    const ImageF image = readExr(folder / "storm_0001.exr", &metadata);
    CHECK(image.size == glm::ivec2(48, 32));
    CHECK(contains(textOf(metadata, "nephoscope.data"), "0001-01-01_01:00:00"));
    CHECK(std::filesystem::exists(folder / "storm_0002.exr"));
    CHECK(image.pixels != readExr(folder / "storm_0002.exr").pixels);
}

TEST_CASE("The camera of another preset is taken alone") {
    const TemporaryFolder folder;
    std::ofstream(folder / "camera.json") << R"({"azimuth_deg": 12, "distance": 2})";
    const auto file = folder / "a.png";
    REQUIRE(runProgram("render " + kStormFile + kQuickest + "--camera " +
                       (folder / "camera.json").string() + " --out " + file.string())
                .status == 0);
    CHECK(contains(textOf(readPngMetadata(file), "nephoscope.camera"), "distance 2 azimuth 12"));
}

TEST_CASE("An existing image stays as it is when rendering fails") {
    const TemporaryFolder folder;
    const auto file = folder / "a.png";
    std::ofstream(file) << "old";
    CHECK(runProgram("render no-such-file --out " + file.string()).status == 1);
    CHECK(readText(file) == "old");
}

TEST_CASE("A place that cannot be written is refused before the work") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "a.png");
    for (const std::string command : {"render --out ", "bench --json "}) {
        const Outcome outcome = runProgram(command + (folder / "a.png").string());
        CHECK(outcome.status == 1);
        CHECK(outcome.err.starts_with("error: "));  // no frame was drawn before
        CHECK(contains(outcome.err, "the name of a file"));
    }
}

TEST_CASE("Presets are listed, shown as a whole and checked") {
    const Outcome list = runProgram("presets");
    CHECK(list.status == 0);
    CHECK(contains(list.out, "default"));
    CHECK(runProgram("presets list").out == list.out);
    const Outcome show = runProgram("presets show default");
    CHECK(show.status == 0);
    CHECK(nlohmann::json::parse(show.out)["type"] == "nephoscope-look");
    CHECK(runProgram("presets check default").status == 0);
}

TEST_CASE("Presets are compared, and those of the user's are kept from the command line") {
    const Outcome diff = runProgram("presets diff default fig06-physical");
    CHECK(diff.status == 0);
    CHECK(contains(diff.out, "Light: Transport Full -> Low albedo\n"));
    CHECK(contains(diff.out, "Camera: Target east"));
    CHECK(contains(runProgram("presets diff default default").out, "no difference"));
    const TemporaryFolder home;
    const auto run = [&](const std::string& arguments) {
        return runProgram("presets " + arguments, home.path().string());
    };
    CHECK(run("save dusk --set sun.elevation=5 --title 'At dusk'").status == 0);
    CHECK(run("save dusk").status == 1);  // nothing is replaced unasked
    CHECK(run("duplicate dusk").out == "dusk 2\n");
    CHECK(run("rename 'dusk 2' dawn").status == 0);
    CHECK(run("describe dawn --description east").status == 0);
    const Outcome list = run("list");
    CHECK(std::regex_search(list.out, std::regex("dawn +yours +At dusk\n")));
    CHECK(std::regex_search(list.out, std::regex("default +bundled +\\w")));
    const auto dawn = nlohmann::json::parse(run("show dawn").out);
    CHECK(dawn["look"]["sun.elevation"] == 5);
    CHECK(dawn["description"] == "east");
    CHECK(run("delete dawn default").status == 1);
    CHECK_FALSE(contains(run("list").out, "dawn"));
    CHECK(std::filesystem::exists(home / "Trash" / "files" / "dawn.json"));
}

TEST_CASE("Checking a preset with an unknown key fails and names the nearest one") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.json")
        << R"({"type": "nephoscope-look", "version": 1, "look": {"sun.azimut": 1}})";
    const Outcome outcome = runProgram("presets check " + (folder / "a.json").string());
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.err, "sun.azimuth"));
}

TEST_CASE("A preset with sampling is right, and a note says that it is read without it") {
    const TemporaryFolder home;
    const auto file = (home / "old.json").string();
    std::ofstream(file) << R"({"type": "nephoscope-look", "version": 1, "look": {"view.seed": 7}})";
    const Outcome checked = runProgram("presets check " + file);
    CHECK(checked.status == 0);
    CHECK(contains(checked.err, "note: " + file + ": view.seed not taken over"));
    CHECK(contains(checked.out, "right"));
    const Outcome saved = runProgram("presets save mine --set view.seed=7", home.path().string());
    CHECK(saved.status == 0);
    CHECK(contains(saved.err, "view.seed=7"));
    CHECK_FALSE(contains(runProgram("presets show mine", home.path().string()).out, "view.seed"));
}

TEST_CASE("The page of parameters is what the program prints") {
    const Outcome printed = runProgram("presets parameters");
    CHECK(printed.status == 0);
    // On a difference: nephoscope presets parameters > docs/parameters.md
    CHECK((printed.out == readText(kSource + "/docs/parameters.md")));
}

TEST_CASE("Info speaks JSON when asked, and names every time of the bundled storm") {
    const Outcome outcome = runProgram("info --json");
    REQUIRE(outcome.status == 0);
    const auto document = nlohmann::json::parse(outcome.out);
    CHECK(contains(document.dump(), "0001-01-01_02:00:00"));
    CHECK(runProgram("readers").status == 0);
}
