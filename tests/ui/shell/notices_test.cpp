// notices_test.cpp: every state has words, and they stay over the image.
#include <doctest/doctest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <thread>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "core/session/autosave.h"
#include "tests/core/fake_series.h"
#include "tests/temporary_folder.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

/// The series without the one species that it has.
class NoClouds : public FakeDataset {
  public:
    NoClouds(const std::shared_ptr<FakeSeries>& series, const std::filesystem::path& file)
        : FakeDataset(series, file) {
        std::erase_if(info_.variables, [](const VariableInfo& v) { return v.name == "qc"; });
    }
};

void openAndWait(Session& session) {
    session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
    REQUIRE(waitUntilShown(session));
}

/// Lays the panels out; checks that this notice, and no other, is there and within the image.
void checkNotice(Headless& gui, ui::Ui& state, const std::string& wanted) {
    CAPTURE(wanted);
    for (const ImVec2 size : {ImVec2(960.0f, 600.0f), ImVec2(1280.0f, 720.0f)}) {
        ImGui::GetIO().DisplaySize = size;
        for (int i = 0; i < 4; ++i) gui.frame([&] { ui::draw(state); });
        const ui::Area image = state.layout().image;
        for (const char* name : {"##nodata", "##loading", "##nohydrometeors", "##clear", "##off",
                                 "##error", "##crashed", "##keys"}) {
            CAPTURE(name);
            const ImGuiWindow* window = ImGui::FindWindowByName(name);
            const bool there = window != nullptr && window->WasActive;
            CHECK(there == (name == wanted));
            if (!there) continue;
            CHECK(window->Pos.x >= image.lower.x);
            CHECK(window->Pos.y >= image.lower.y);
            CHECK(window->Pos.x + window->Size.x <= image.upper.x);
            CHECK(window->Pos.y + window->Size.y <= image.upper.y);
            CHECK(window->Size.x > 100.0f);
        }
    }
}

}  // namespace

TEST_CASE("Without data the start screen says what to do, with what was opened recently") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    for (int i = 0; i < 12; ++i) state.settings.recent.push_back("/data/" + std::to_string(i));
    checkNotice(gui, state, "##nodata");
}

TEST_CASE("A first run hints at the keys until the hint is closed or was followed") {
    Headless gui;
    Session session(openFake(std::make_shared<FakeSeries>()));
    openAndWait(session);
    ui::Ui state(session);
    checkNotice(gui, state, "");
    for (const char* followed : {"help.sheet", "help.commands"}) {
        CAPTURE(followed);
        state.hintsAtKeys = true;
        checkNotice(gui, state, "##keys");
        CHECK(ui::runAction(state, followed));
        for (int i = 0; i < 4; ++i) gui.frame([&] { ui::draw(state); });
        CHECK_FALSE(state.hintsAtKeys);
        state.showHelp = false;
    }
}

TEST_CASE("An error is told over the image until it is closed") {
    Headless gui;
    Session session(openFake(std::make_shared<FakeSeries>()));
    openAndWait(session);
    ui::Ui state(session);
    std::string text = "a fault";
    for (int i = 0; i < 60; ++i) text += "\n       with many lines";
    session.say(Message::Kind::error, text);
    checkNotice(gui, state, "##error");
    CHECK(ui::runAction(state, "help.close"));
    checkNotice(gui, state, "");
}

TEST_CASE("A clear sky, fields switched off and data without hydrometeors are told apart") {
    Headless gui;
    {
        Session session(openFake(std::make_shared<FakeSeries>()));
        openAndWait(session);
        ui::Ui state(session);
        checkNotice(gui, state, "");
        session.document.look.of(Species::cloud).visible = false;  // all that these data have
        checkNotice(gui, state, "##off");
    }
    {
        Session session(openFake(std::make_shared<FakeSeries>()));
        openAndWait(session);
        ui::Ui state(session);
        session.setRegion(BoxM{{5000.0, 0.0, 0.0}, {8000.0, 8000.0, 2000.0}});
        for (int i = 0; i < 10000 && !session.shown()->empty(); ++i) {
            session.poll();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        checkNotice(gui, state, "##clear");
    }
    auto series = std::make_shared<FakeSeries>();
    Session session([series](std::span<const std::filesystem::path> paths, const Progress&) {
        return std::make_shared<NoClouds>(series, paths.front());
    });
    openAndWait(session);
    ui::Ui state(session);
    checkNotice(gui, state, "##nohydrometeors");
}

TEST_CASE("An export and the performance are told over the image, and over no column") {
    Headless gui;
    Session session(openFake(std::make_shared<FakeSeries>()));
    openAndWait(session);
    ui::Ui state(session);
    state.showProfile = true;
    state.output.job.emplace("/bin/true", std::vector<std::string>{});
    ImGui::GetIO().DisplaySize = {960.0f, 600.0f};
    for (const float columns : {15.0f, 28.0f}) {
        CAPTURE(columns);
        state.settings.leftColumnEms = state.settings.rightColumnEms = columns;
        for (int i = 0; i < 4; ++i) gui.frame([&] { ui::draw(state); });
        const ui::Area image = state.layout().image;
        for (const char* name : {"##export", "##profile"}) {
            CAPTURE(name);
            const ImGuiWindow* window = ImGui::FindWindowByName(name);
            REQUIRE(window != nullptr);
            CHECK(window->WasActive);
            CHECK(window->Pos.x >= image.lower.x);
            CHECK(window->Pos.x + window->Size.x <= image.upper.x);
        }
    }
}

TEST_CASE("Opening is told with its progress, and cancelling goes back to the start") {
    Headless gui;
    auto series = std::make_shared<FakeSeries>();
    series->slowMs = 20000;
    Session session(openFake(series));
    session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
    ui::Ui state(session);
    checkNotice(gui, state, "##loading");
    session.cancelLoading();
    CHECK_FALSE(session.loading());
    checkNotice(gui, state, "##nodata");
}

TEST_CASE("A time whose reading is given up leaves the one that is shown") {
    auto series = std::make_shared<FakeSeries>();
    Session session(openFake(series));
    openAndWait(session);
    series->slowMs = 20000;
    session.document.time = 3;
    session.poll();
    CHECK(session.loading());
    session.cancelLoading();
    session.poll();
    CHECK_FALSE(session.loading());
    CHECK(session.document.time == 0);
    CHECK(session.shown()->timeLabel == "time 0");
}
