// member_test.cpp: stepping through the members of an ensemble, and the panel of its maps.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "app/ui/time/time_bar.h"
#include "tests/core/fake_series.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

/// As readers have it: another thread can read the same.
struct SharedFake : FakeDataset {
    using FakeDataset::FakeDataset;
    std::unique_ptr<Dataset> anotherHandle() const override {
        return std::make_unique<SharedFake>(*this);
    }
};

/// Three members, of which the middle one has the first of two times alone.
struct Members {
    Members() {
        std::vector<std::string> runs;
        for (int i = 0; i < 3; ++i) {
            series.push_back(std::make_shared<FakeSeries>());
            series.back()->times = i == 1 ? 1 : 2;
            runs.push_back((folder / ("mem0" + std::to_string(i + 1))).string());
            std::ofstream(runs.back()) << "x";
        }
        session.openAs({.named = runs, .members = true, .time = 1});
        REQUIRE(waitUntilShown(session));
    }
    const TemporaryFolder folder;
    std::vector<std::shared_ptr<FakeSeries>> series;
    Session session{[this](std::span<const std::filesystem::path> paths, const Progress&) {
        const auto name = paths.front().filename().string();
        return std::make_shared<SharedFake>(series.at(static_cast<std::size_t>(name.back() - '1')),
                                            paths.front());
    }};
};

}  // namespace

TEST_CASE("A step passes over a member that lacks the time, and says so") {
    Members members;
    Session& session = members.session;
    ui::stepMember(session, 1);
    CHECK(session.document.member == 2);
    CHECK(contains(session.messages.back().text, "member mem02: has no time time 1"));
    ui::stepMember(session, 1);
    CHECK(session.document.member == 2);
    ui::stepMember(session, -1);
    CHECK(session.document.member == 0);
    session.document.member = kMeanMember;
    ui::stepMember(session, -1);
    CHECK(session.document.member == 2);
    session.document.member = kMeanMember;
    ui::stepMember(session, 1);
    CHECK(session.document.member == 0);
}

TEST_CASE("The ensemble map is read in the background, and follows the time that is shown") {
    const Headless headless;
    Members members;
    ui::Ui state(members.session);
    REQUIRE(ui::runAction(state, "view.ensemble_map"));
    const auto read = [&](std::size_t count) {
        for (int i = 0; i < 5000; ++i) {
            members.session.poll();
            ImGui::NewFrame();
            ui::draw(state);
            ImGui::Render();
            const auto& depths = state.ensemble.depths;
            if (depths && depths->members.size() == count && !state.ensemble.wantedOf) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    };
    REQUIRE(read(2));
    CHECK(state.ensemble.depths->without == std::vector<std::string>{"mem02"});
    CHECK(state.ensemble.figure.field->values.size() == 64);
    // Columns 2 to 4 of FakeDataset have cloud.
    CHECK(state.ensemble.figure.field->values[3] == 1.0f);
    CHECK(state.ensemble.figure.field->values[6] == 0.0f);
    members.session.document.time = 0;
    CHECK(read(3));
}
