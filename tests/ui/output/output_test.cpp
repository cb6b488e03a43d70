// output_test.cpp: the export dialogue: command lines, file names, and a job pretended by a script.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "app/ui/output/output_panel.h"
#include "app/ui/output/output_run.h"
#include "app/ui/shell/actions.h"
#include "app/ui/shell/context.h"
#include "app/ui/widgets/places.h"
#include "core/session/session_file.h"
#include "tests/environment.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"
#include "tests/ui/headless.h"

using namespace neph;
using namespace neph::ui;

namespace {

/// "a b c" of the arguments.
std::string lineOf(const ExportSettings& settings, const ExportScene& scene) {
    std::string line;
    for (const std::string& argument : exportArguments(settings, scene, "s.json", "o.png")) {
        line += argument + " ";
    }
    return line;
}

void makeProgram(const std::filesystem::path& file, const std::string& script) {
    std::ofstream(file) << "#!/bin/sh\n" << script;
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}

}  // namespace

TEST_CASE("Settings become the command line that a user would type") {
    ExportSettings settings;
    ExportScene scene{{800, 450}, 2, false, {}};
    CHECK(lineOf(settings, scene) ==
          "render --progress --session s.json --slot 2 --size 800x450 --supersample 1 --samples 16 "
          "--out o.png ");
    settings.what = ExportWhat::times;
    settings.size = ExportSize::uhd;
    settings.transparent = true;
    settings.supersample = 2;
    scene.readers = {"a.so"};
    CHECK(lineOf(settings, scene) ==
          "render --progress --session s.json --slot 2 --time all --size 3840x2160 "
          "--supersample 2 --samples 16 --transparent --reader a.so --out o.png ");
    settings.what = ExportWhat::path;
    settings.format = ExportFormat::mp4;
    scene.split = true;
    const std::string video = lineOf(settings, scene);
    CHECK(contains(video, "--compare --along-path --fps 25"));
    CHECK_FALSE(contains(video, "--transparent"));
    CHECK_FALSE(contains(video, "--slot"));
    settings.what = ExportWhat::times;
    CHECK(contains(lineOf(settings, scene), "--time all --fps 25"));
    scene.averages = false;
    CHECK_FALSE(contains(lineOf(settings, scene), "--samples"));
}

TEST_CASE("A file's ending is that of its format, and other dots are part of its name") {
    CHECK(withEnding("a/b.png", ExportFormat::exr) == "a/b.exr");
    CHECK(withEnding("a/b", ExportFormat::mp4) == "a/b.mp4");
    CHECK(withEnding("storm.0001-01-01", ExportFormat::png) == "storm.0001-01-01.png");
}

TEST_CASE("No export writes over what is there, be it a file or an image of a series") {
    const TemporaryFolder folder;
    CHECK(freeFile(folder / "a.png", true) == folder / "a.png");
    std::ofstream(folder / "a_0007.png") << "x";
    CHECK(freeFile(folder / "a.png", false) == folder / "a.png");
    CHECK(freeFile(folder / "a.png", true) == folder / "a-2.png");
    std::ofstream(folder / "a.png") << "x";
    std::ofstream(folder / "a-2.png") << "x";
    CHECK(freeFile(folder / "a.png", false) == folder / "a-3.png");
    CHECK(freeFile(folder / "a.exr", true) == folder / "a.exr");
    CHECK(freeFile(folder / "a_b.png", true) == folder / "a_b.png");
}

TEST_CASE("The images folder is the place for images, where there is one") {
    const TemporaryFolder folder;
    const Environment home("HOME", folder.path().string());
    CHECK(defaultExportFile().parent_path() == std::filesystem::current_path());
    std::filesystem::create_directory(folder / "Images");
    CHECK(defaultExportFile() == folder / "Images" / "nephoscope.png");
}

TEST_CASE("An export reads what the window holds, is told when it is there, and cleans up") {
    const TemporaryFolder folder;
    const Environment cache("XDG_CACHE_HOME", folder.path().string());
    Headless gui;
    Session session(noReaders());
    Ui ui(session);
    ui.services.state = [] {
        SessionState state;
        state.slots.resize(1);
        state.slots.front().presetName = "mine";
        return state;
    };
    ui.output.program = folder / "program";
    ui.output.settings.file = (folder / "p.exr").string();
    const auto start = [&] {
        startExport(contextOf(ui), ui.output, ui.output.settings, exportSceneOf(ui));
    };
    const auto draw = [&] {
        gui.frame([&] { drawOutput(contextOf(ui), ui.output, exportSceneOf(ui)); });
    };
    const auto finish = [&] {
        for (int i = 0; i < 2 || exports(ui.output); ++i) draw();
    };
    SUBCASE("well") {
        makeProgram(ui.output.program,
                    "cp \"$4\" " + (folder / "copy").string() +
                        "; echo '{\"done\": 1, \"of\": 1, \"file\": \"p.png\"}'");
        exportImage(contextOf(ui), ui.output, exportSceneOf(ui));
        REQUIRE(exports(ui.output));
        CHECK_FALSE(runAction(ui, "output.image"));
        finish();
        CHECK(ui.output.job->state() == ExportJob::State::done);
        CHECK(session.messages.back().text == "Wrote p.png");
        CHECK(loadSession(folder / "copy").slots.front().presetName == "mine");
    }
    SUBCASE("stopped") {
        makeProgram(ui.output.program, "trap 'exit 143' TERM; while :; do sleep 0.01; done");
        start();
        draw();
        CHECK(ui.next.againS <= 0.2);
        CHECK(runAction(ui, "output.cancel"));
        finish();
        CHECK(ui.output.job->state() == ExportJob::State::cancelled);
    }
    SUBCASE("failing") {
        makeProgram(ui.output.program, "echo '{\"error\": \"no room\"}'; exit 1");
        start();
        ui.output.open = true;
        finish();
        CHECK(ui.output.job->fault() == "no room");
    }
    SUBCASE("without a program") {
        start();
        CHECK_FALSE(exports(ui.output));
        CHECK(contains(session.messages.back().text, "program"));
    }
    CHECK(std::filesystem::is_empty(folder / "nephoscope" / "exports"));
}

TEST_CASE("The window asks before it closes on an export: wait, stop it, or let it go on") {
    const TemporaryFolder folder;
    const Environment cache("XDG_CACHE_HOME", folder.path().string());
    const auto held = folder / "nephoscope" / "exports", done = folder / "done";
    Headless gui;
    wantPlaces(true);
    Session session(noReaders());
    Ui ui(session);
    ui.services.state = [] { return SessionState{.slots = std::vector<SlotState>(1)}; };
    ui.output.program = folder / "program";
    ui.output.settings.file = (folder / "p.png").string();
    makeProgram(ui.output.program, "while [ ! -e " + (folder / "go").string() +
                                       " ]; do sleep 0.01; done; echo 'wrote p.png' >&2; touch " +
                                       done.string());
    const auto draw = [&](int frames) {
        for (int i = 0; i < frames; ++i) {
            clearPlaces();
            gui.frame([&] { drawOutput(contextOf(ui), ui.output, exportSceneOf(ui)); });
        }
    };
    const auto click = [&](const char* name) {
        const auto at = placeOf(name);
        REQUIRE_MESSAGE(at.has_value(), name);
        ImGui::GetIO().MousePos = {at->lower.x + 5.0f, at->lower.y + 5.0f};
        for (const bool down : {false, true, false}) {
            ImGui::GetIO().MouseDown[0] = down;
            draw(1);
        }
    };
    const auto waitFor = [&](const auto& condition) {
        for (int i = 0; i < 5000 && !condition(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            draw(1);
        }
        return condition();
    };
    CHECK(mayQuit(ui.output));  // nothing is running
    exportImage(contextOf(ui), ui.output, exportSceneOf(ui));
    CHECK_FALSE(mayQuit(ui.output));
    draw(4);
    SUBCASE("no answer") {
        click("quit.cancel");
        CHECK_FALSE(ui.output.asksToQuit);
        CHECK_FALSE(ui.requests.quit);
        CHECK(exports(ui.output));
        std::ofstream(folder / "go") << "x";
        CHECK(waitFor([&] { return !exports(ui.output); }));
        CHECK_FALSE(ui.requests.quit);
    }
    SUBCASE("wait") {
        click("quit.after");
        CHECK_FALSE(ui.requests.quit);
        std::ofstream(folder / "go") << "x";
        CHECK(waitFor([&] { return ui.requests.quit; }));
        CHECK(mayQuit(ui.output));
    }
    SUBCASE("stop") {
        click("quit.stop");
        CHECK(ui.requests.quit);
        CHECK(mayQuit(ui.output));
        CHECK(std::filesystem::is_empty(held));
        CHECK_FALSE(std::filesystem::exists(done));
    }
    SUBCASE("let it go on") {
        click("quit.leave");
        CHECK(ui.requests.quit);
        CHECK(mayQuit(ui.output));
        ui.output.job.reset();  // as when the window has gone
        CHECK_FALSE(std::filesystem::is_empty(held));
        std::ofstream(folder / "go") << "x";
        CHECK(waitFor([&] { return std::filesystem::exists(done); }));
        CHECK(waitFor([&] { return std::filesystem::is_empty(held); }));
    }
    wantPlaces(false);
}

TEST_CASE("A video without ffmpeg, and a path without keys, say what to do") {
    const TemporaryFolder folder;
    Session session(noReaders());
    ExportSettings settings;
    settings.file = "a.png";
    CHECK(contains(exportFault(settings, session), "no data"));
}
