// session_dialogs_test.cpp: opening, saving and restoring, with a window that is made up.
#include "app/ui/data/session_dialogs.h"

#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <thread>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/context.h"
#include "app/ui/shell/frame.h"
#include "app/ui/shell/wishes.h"
#include "core/preset/preset.h"
#include "core/session/autosave.h"
#include "core/session/session_file.h"
#include "tests/core/fake_series.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;

/// A window that takes over states instead of showing them.
struct Window {
    Window() {
        state.services.state = [this] { return now; };
        state.services.restore = [this](const SessionState& to) {
            now = to;
            ++restored;
        };
        now.slots.resize(1);
    }
    std::string lastMessage() const {
        return session.messages.empty() ? std::string() : session.messages.back().text;
    }
    void openSessionFile(const fs::path& file) {
        ui::openSessionFile(ui::contextOf(state), state.sessionDialogs, file);
    }
    void saveSessionFile(const fs::path& file) {
        ui::saveSessionFile(ui::contextOf(state), state.sessionDialogs, file);
    }
    void openData() {
        session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
        for (int i = 0; i < 10000 && session.loading(); ++i) {
            session.poll();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    Session session{openFake(std::make_shared<FakeSeries>())};
    ui::Ui state{session};
    SessionState now;
    int restored = 0;
};

SessionState stateWith(const std::string& data) {
    SessionState state;
    state.slots.resize(1);
    state.slots[0].data = {data};
    state.slots[0].document.camera.distance = 0.5f;
    return state;
}

}  // namespace

TEST_CASE("A session that is named is restored, a preset is loaded, and both are told from data") {
    const TemporaryFolder folder;
    Window window;
    const fs::path file = folder / "a.nephoscope.json";
    saveSession(file, stateWith(folder.path().string()));
    ui::openFiles(window.state, {file.string()});
    CHECK(window.restored == 1);
    CHECK(window.now == loadSession(file));
    CHECK(window.state.sessionDialogs.file == file);
    CHECK(window.state.settings.recent == std::vector<std::string>{file.string()});
    Preset preset;
    preset.look.of(Species::cloud).mixingScale = 0.25f;
    savePreset(folder / "p.json", preset);
    ui::openFiles(window.state, {(folder / "p.json").string()});
    CHECK(window.session.document.look.of(Species::cloud).mixingScale == 0.25f);
    CHECK(window.restored == 1);
    ui::openFiles(window.state, {(folder / "none").string()});
    CHECK(contains(window.lastMessage(), "no such file"));
    ui::openFiles(window.state, {"https://a.org/wrfout_d01"});
    CHECK(contains(window.lastMessage(), "curl -fLO https://a.org/wrfout_d01"));
    fs::create_symlink("/gone/wrfout", folder / "link");
    ui::openFiles(window.state, {(folder / "link").string()});
    CHECK(contains(window.lastMessage(), "/gone/wrfout"));
}

TEST_CASE("A session whose data have moved waits for an answer and loses nothing") {
    const TemporaryFolder folder;
    Headless gui;
    Window window;
    saveSession(folder / "a.json", stateWith("/gone/run"));
    window.openSessionFile(folder / "a.json");
    CHECK(window.restored == 0);
    REQUIRE(window.state.sessionDialogs.waiting.has_value());
    ui::WaitingSession& waiting = *window.state.sessionDialogs.waiting;
    CHECK(waiting.missing == std::vector<std::string>{"/gone/run"});
    for (int i = 0; i < 3; ++i) gui.frame([&] { ui::draw(window.state); });
    ui::answer(waiting, "/also/gone");
    CHECK(waiting.missing.size() == 1);
    fs::create_directory(folder / "run");
    ui::answer(waiting, folder.path().string());
    CHECK(waiting.missing.empty());
    gui.frame([&] { ui::draw(window.state); });
    CHECK_FALSE(window.state.sessionDialogs.waiting.has_value());
    CHECK(window.restored == 1);
    CHECK(window.now.slots[0].data == std::vector<std::string>{folder / "run"});
    CHECK(window.now.slots[0].document.camera.distance == 0.5f);
}

TEST_CASE("Without the data that are missing, look and camera are taken over all the same") {
    const TemporaryFolder folder;
    Headless gui;
    Window window;
    saveSession(folder / "a.json", stateWith("/gone/run"));
    window.openSessionFile(folder / "a.json");
    REQUIRE(window.state.sessionDialogs.waiting.has_value());
    ui::leaveOut(window.session, *window.state.sessionDialogs.waiting);
    for (int i = 0; i < 2; ++i) gui.frame([&] { ui::draw(window.state); });
    CHECK(window.restored == 1);
    CHECK(window.now.slots[0].data.empty());
    CHECK(window.now.slots[0].document.camera.distance == 0.5f);
}

TEST_CASE("A session is saved under its name, and a fault is told") {
    const TemporaryFolder folder;
    Window window;
    window.now = stateWith(folder.path().string());
    window.saveSessionFile(folder / "a.json");
    CHECK(loadSession(folder / "a.json") == window.now);
    CHECK(contains(window.lastMessage(), "a.json"));
    window.now.slots[0].document.time = 3;
    CHECK(ui::runAction(window.state, "file.save_session"));
    CHECK(loadSession(folder / "a.json").slots[0].document.time == 3);
    window.saveSessionFile(folder / "missing/a.json");
    CHECK(contains(window.lastMessage(), "missing"));
    CHECK(window.state.sessionDialogs.file == folder / "a.json");
}

TEST_CASE("What a crash left is offered, restored, and forgotten when it is saved again") {
    const TemporaryFolder folder;
    Headless gui;
    saveSession(folder / "window-left.json", stateWith(folder.path().string()));
    Autosave autosave(folder.path());
    Window window;
    window.state.sessionDialogs.autosave = &autosave;
    window.state.sessionDialogs.offersCrashed = true;
    for (int i = 0; i < 3; ++i) gui.frame([&] { ui::draw(window.state); });
    CHECK(contains(window.state.sessionDialogs.crashText, "less than a minute ago"));
    CHECK(contains(window.state.sessionDialogs.crashText, folder.path().filename().string()));
    CHECK(ui::runAction(window.state, "file.reopen"));
    CHECK(window.restored == 1);
    CHECK(autosave.crashed() != nullptr);
    window.openData();
    gui.frame([&] { ui::draw(window.state); });
    autosave.tick(window.state.services.state, Autosave::Clock::now());
    autosave.wait();
    CHECK(autosave.crashed() == nullptr);
    CHECK_FALSE(ui::runAction(window.state, "file.reopen"));  // nothing else was left
}

TEST_CASE("Times that have passed are told as people do") {
    CHECK(ui::agoText(-5.0) == "less than a minute ago");
    CHECK(ui::agoText(59.0) == "less than a minute ago");
    CHECK(ui::agoText(60.0) == "1 minute ago");
    CHECK(ui::agoText(7300.0) == "2 hours ago");
    CHECK(ui::agoText(200000.0) == "2 days ago");
}
