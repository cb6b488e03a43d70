// export_test.cpp: `nephoscope render` beyond single images: sizes, videos, sessions, paths,
// comparisons, progress and being told to stop. The bundled cumulus, small and coarse.
#include <doctest/doctest.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "app/image_io/exr.h"
#include "app/image_io/png.h"
#include "core/base/child_process.h"
#include "core/camera/camera_format.h"
#include "core/session/session_file.h"
#include "core/session/thumbnail.h"
#include "tests/cli/program.h"
#include "tests/environment.h"

using namespace neph;

namespace {

// With light that needs no solution.
const std::string kQuick =
    "render cumulus --set light.transport=low_albedo --quality 0.25 --samples 1 ";

std::string quoted(const std::filesystem::path& path) {
    return "'" + path.string() + "'";
}

std::size_t countFiles(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

/// An ffmpeg that writes its arguments and the number of bytes it was given to its last argument.
void makeFfmpeg(const std::filesystem::path& folder, const std::string& more = "") {
    std::ofstream(folder / "ffmpeg")
        << "#!/bin/sh\nbytes=$(wc -c)\nfor last; do :; done\necho \"$* $bytes\" > \"$last\"\n"
        << more;
    std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
}

/// Two keys a second apart, and a slot on the cumulus.
SessionState cumulusSession() {
    SessionState state;
    state.slots.resize(2);
    for (SlotState& slot : state.slots) {
        slot.data = {"cumulus"};
        slot.document.sampling.quality = 0.25f;
        slot.document.time = 2;
    }
    state.slots[0].document.camera.azimuthDeg = 90.0f;
    state.slots[1].document.camera.azimuthDeg = 270.0f;
    state.slots[0].document.path.keys = {{0.0, {}}, {1.0, {}}};
    state.slots[0].document.path.keys[1].pose.azimuthDeg = 200.0f;
    return state;
}

}  // namespace

TEST_CASE("An image wider than any texture is written, and its pixels go on over the seam") {
    const TemporaryFolder folder;
    const Outcome outcome =
        runProgram(kQuick + "--size 20000x2 --out " + quoted(folder / "wide.png"));
    CHECK_MESSAGE(outcome.status == 0, outcome.err);
    const Image8 image = readPng(folder / "wide.png");
    REQUIRE(image.size == glm::ivec2(20000, 2));
    for (std::size_t x = 16380; x < 16390; ++x) {
        for (std::size_t c = 0; c < 3; ++c) {
            CHECK(std::abs(image.rgba[4 * x + c] - image.rgba[4 * x + 4 + c]) <= 2);
        }
    }
}

TEST_CASE("A transparent image is clear where there is no cloud and opaque in its middle") {
    const TemporaryFolder folder;
    for (const char* name : {"t.png", "t.exr"}) {
        const Outcome outcome = runProgram(
            kQuick + "--size 48x32 --supersample 2 --transparent --camera fig01-cumulus --out " +
            quoted(folder / name));
        CHECK_MESSAGE(outcome.status == 0, outcome.err);
    }
    const Image8 png = readPng(folder / "t.png");
    CHECK(png.rgba[3] == 0);
    int opaque = 0;
    for (std::size_t i = 3; i < png.rgba.size(); i += 4) opaque += png.rgba[i] == 255 ? 1 : 0;
    CHECK(opaque > 20);
    const ImageF exr = readExr(folder / "t.exr");
    CHECK(exr.pixels.front() == glm::vec4(0.0f));
    for (std::size_t i = 0; i < exr.pixels.size(); ++i) {
        CHECK(std::abs(exr.pixels[i].a - static_cast<float>(png.rgba[4 * i + 3]) / 255.0f) <
              0.003f);
    }
}

TEST_CASE("Progress is a line of JSON an image, and images of all times are numbered") {
    const TemporaryFolder folder;
    const Outcome outcome =
        runProgram(kQuick + "--size 16x16 --time 1:2 --progress --out " + quoted(folder / "c.png"));
    CHECK_MESSAGE(outcome.status == 0, outcome.err);
    std::istringstream lines(outcome.out);
    int done = 0;
    for (std::string line; std::getline(lines, line);) {
        const auto told = nlohmann::json::parse(line);
        CHECK(told["of"] == 2);
        if (!told.contains("file")) continue;
        ++done;
        CHECK(told["done"] == done);
        CHECK(std::filesystem::exists(told["file"].get<std::string>()));
    }
    CHECK(done == 2);
    CHECK(std::filesystem::exists(folder / "c_0002.png"));
}

TEST_CASE("Progress ends with the error where there is one, be it in the options or in the work") {
    for (const char* arguments : {"--progress --fps 5", "--progress none-such"}) {
        const Outcome outcome = runProgram(std::string("render ") + arguments);
        CHECK(outcome.status != 0);
        const auto told = nlohmann::json::parse(outcome.out);
        CHECK(outcome.err == "error: " + told["error"].get<std::string>() + "\n");
    }
}

TEST_CASE("A video's frames go to ffmpeg, whole and in order, with even sides") {
    const TemporaryFolder folder;
    makeFfmpeg(folder.path());
    const Environment path("PATH", folder.path().string() + ":" + std::getenv("PATH"));
    const Outcome outcome =
        runProgram(kQuick + "--size 17x16 --time all --fps 5 --out " + quoted(folder / "f.mp4"));
    CHECK_MESSAGE(outcome.status == 0, outcome.err);
    CHECK(contains(outcome.err, "16x16"));
    const std::string told = readText(folder / "f.mp4");
    CHECK(contains(told, "-f rawvideo -pix_fmt rgb24 -s 16x16 -r 5 -i -"));
    CHECK(contains(told, "libx264"));
    CHECK(contains(told, "-pix_fmt yuv420p"));
    CHECK(contains(told, " 2304\n"));  // three times of 16 x 16 pixels of three bytes
    CHECK(countFiles(folder.path()) == 2);
}

TEST_CASE("A video that ffmpeg does not make is an error in its words, and leaves no file") {
    const TemporaryFolder folder;
    makeFfmpeg(folder.path(), "echo 'Unknown encoder' >&2\nexit 8\n");
    const Environment path("PATH", folder.path().string() + ":" + std::getenv("PATH"));
    const Outcome outcome = runProgram(kQuick + "--size 16x16 --out " + quoted(folder / "f.mp4"));
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.err, "Unknown encoder"));
    CHECK(countFiles(folder.path()) == 1);
}

TEST_CASE("Without ffmpeg a video says so before any work, and what to do") {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/usr/bin/env", folder / "env");
    const Environment path("PATH", folder.path().string());
    const Outcome outcome = runProgram("render none-such --out f.mp4");
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.err, "apt install ffmpeg"));
    CHECK(contains(outcome.err, "--out frames.png"));
}

TEST_CASE("A session's slots, camera and path are where an image starts from") {
    const TemporaryFolder folder;
    saveSession(folder / "s.json", cumulusSession());
    const std::string start =
        "render --samples 1 --size 24x16 --session " + quoted(folder / "s.json");
    const auto render = [&](const std::string& more, const char* name) {
        const Outcome outcome = runProgram(start + " " + more + " --out " + quoted(folder / name));
        CHECK_MESSAGE(outcome.status == 0, outcome.err);
    };
    const auto cameraOf = [&](const char* name, const std::string& wanted) {
        for (const auto& [key, text] : readPngMetadata(folder / name)) {
            if (key == wanted) return text;
        }
        return std::string();
    };
    render("--slot 2", "b.png");
    CHECK(contains(cameraOf("b.png", "nephoscope.camera"), "azimuth 270"));
    CHECK(contains(cameraOf("b.png", "nephoscope.data"), "900"));
    render("--along-path --frames 3", "p.png");
    CHECK(contains(cameraOf("p_0000.png", "nephoscope.camera"), "azimuth 180"));
    CHECK(contains(cameraOf("p_0002.png", "nephoscope.camera"), "azimuth 200"));
    CHECK(contains(cameraOf("p_0000.png", "nephoscope.data"), "540"));
    CHECK(contains(cameraOf("p_0001.png", "nephoscope.data"), "720"));
    saveCameraPath(folder / "way.json", cumulusSession().slots[0].document.path);
    render("--path " + quoted(folder / "way.json") + " --fps 1 --time 0", "w.png");
    CHECK(contains(cameraOf("w_0001.png", "nephoscope.camera"), "azimuth 200"));
    CHECK(contains(cameraOf("w_0001.png", "nephoscope.data"), "540"));
    CHECK_FALSE(std::filesystem::exists(folder / "w_0002.png"));
}

TEST_CASE("A comparison is A on the left, B on the right, and a line between") {
    const TemporaryFolder folder;
    const auto render = [&](const std::string& more, const char* name) {
        const Outcome outcome = runProgram("render cumulus --camera default --size 40x20 " + more +
                                           " --out " + quoted(folder / name));
        CHECK_MESSAGE(outcome.status == 0, outcome.err);
        return readPng(folder / name);
    };
    const std::string coarse = "--quality 0.25 --samples 1 ";
    const Image8 a = render(coarse + "--time 1", "a.png");
    const Image8 b = render("--time 2 --preset fig04-field-colours", "b.png");
    const Image8 both = render(
        coarse + "--time 1 --preset-b fig04-field-colours --time-b 2 --split 0.25", "ab.png");
    REQUIRE(both.size == a.size);
    for (std::size_t i = 0; i < both.rgba.size(); ++i) {
        const std::size_t x = i / 4 % 40;
        if (x == 10) {
            CHECK(both.rgba[i] == 255);
        } else {
            CHECK(both.rgba[i] == (x < 10 ? a : b).rgba[i]);
        }
    }
    const Outcome nothing = runProgram("render --split 0.5");
    CHECK(nothing.status == 2);
    CHECK(contains(nothing.err, "--preset-b"));
}

TEST_CASE("An export that is told to stop stops, keeps whole images and leaves no half one") {
    const TemporaryFolder folder;
    ChildProcess child(
        NEPH_TEST_PROGRAM,
        {"render", "cumulus", "--time", "all", "--size", "64x48", "--samples", "1024", "--quality",
         "0.25", "--progress", "--out", (folder / "c.png").string()},
        {});
    while (child.poll() && child.takeLines().empty()) std::this_thread::yield();
    child.cancel();
    CHECK(child.wait() == 128 + SIGTERM);
    CHECK(contains(child.lastWords(), "stopped"));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        CHECK(entry.path().filename().string().starts_with("c_"));
        CHECK(readPng(entry.path()).size == glm::ivec2(64, 48));
    }
}

TEST_CASE("A video that is told to stop, and not only once, leaves no part of it") {
    const TemporaryFolder folder;
    makeFfmpeg(folder.path());
    const Environment path("PATH", folder.path().string() + ":" + std::getenv("PATH"));
    // As many signals as the program that started it had threads.
    const std::string script =
        "cd \"$1\"; \"$0\" render cumulus --time all --size 64x48 --samples 1024 --quality 0.25 "
        "--progress --out f.mp4 > log 2> errors & p=$!\n"
        "while ! grep -q done log; do sleep 0.02; done; kill $p; kill $p; kill $p; wait $p";
    ChildProcess child("/bin/sh", {"-c", script, NEPH_TEST_PROGRAM, folder.path().string()}, {});
    CHECK(child.wait() == 128 + SIGTERM);
    CHECK(contains(readText(folder / "errors"), "stopped"));
    CHECK(countFiles(folder.path()) == 3);  // ffmpeg, log and errors
}

TEST_CASE("Thumbnails are made where the browser looks for them, once") {
    const TemporaryFolder folder;
    const Environment cache("XDG_CACHE_HOME", folder.path().string());
    const auto preset = folder / "coarse.json";
    std::ofstream(preset) << R"({"type": "nephoscope-look", "version": 1, "title": "coarse",
                                 "look": {"mode.noise": false, "light.transport": "low_albedo"}})";
    const auto file = thumbnailFile({"coarse", preset, false});
    REQUIRE(file);
    const std::string make = "thumbnails --preset " + quoted(preset);
    const Outcome first = runProgram(make);
    CHECK_MESSAGE(first.status == 0, first.err);
    CHECK(readPng(*file).size == kThumbnailPx);
    const Outcome second = runProgram(make);
    CHECK(second.status == 0);
    CHECK(second.err.empty());
    const Outcome named = runProgram(make + " --size 16x9 --out " + quoted(folder / "named"));
    CHECK(named.status == 0);
    CHECK(readPng(folder / "named" / "coarse.png").size == glm::ivec2(16, 9));
}
