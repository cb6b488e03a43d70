// session_members_test.cpp: an ensemble as the data of a session: which member is shown, what is
// read ahead, and what is kept.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "core/session/moved_data.h"
#include "core/session/recent.h"
#include "core/session/session_file.h"
#include "tests/core/fake_series.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

using namespace std::chrono_literals;

/// A session with three members of made-up data, of which the last has two times, not three.
struct OpenedMembers {
    explicit OpenedMembers(std::uint64_t volumes = 100) {
        for (int i = 0; i < 3; ++i) {
            series.push_back(std::make_shared<FakeSeries>());
            series.back()->times = i == 2 ? 2 : 3;
            std::ofstream(folder / ("mem0" + std::to_string(i + 1))) << "x";
            runs.push_back((folder / ("mem0" + std::to_string(i + 1))).string());
        }
        session.setBudget({volumes * 8 * 8 * 4 * sizeof(float), kSoftwareGpuBytes});
        session.openAs({.named = runs, .members = true, .time = 0, .memberName = "mem02"});
        REQUIRE(until([&] { return session.shown() != nullptr; }));
    }
    bool until(const auto& done) {
        const auto end = std::chrono::steady_clock::now() + 10s;
        while (std::chrono::steady_clock::now() < end) {
            session.poll();
            if (done()) return true;
            std::this_thread::sleep_for(1ms);
        }
        return false;
    }
    bool showsMember(int member) {
        return until([&] {
            return !session.loading() && session.document.member == member &&
                   session.shows(session.document.time);
        });
    }
    bool says(std::string_view text) const {
        return std::ranges::any_of(
            session.messages, [&](const Message& message) { return contains(message.text, text); });
    }

    const TemporaryFolder folder;
    std::vector<std::shared_ptr<FakeSeries>> series;
    std::vector<std::string> runs;
    Session session{[this](std::span<const std::filesystem::path> paths, const Progress&) {
                        const auto name = paths.front().filename().string();
                        return std::make_shared<FakeDataset>(
                            series.at(static_cast<std::size_t>(name.back() - '1')), paths.front());
                    },
                    {},
                    5ms};
};

}  // namespace

TEST_CASE(
    "A session shows the member that is asked for, others at once when read ahead, the mean") {
    OpenedMembers opened;
    Session& session = opened.session;
    CHECK(session.ensemble()->nameOf(session.document.member) == "mem02");
    CHECK(opened.says("mem03 lacks 1 of 3 times: time 2."));
    session.document.member = 2;
    CHECK(opened.showsMember(2));
    // Every member is in memory in the end: a step to one is shown by the next poll.
    REQUIRE(opened.until([&] { return session.heldOf(0) != nullptr; }));
    session.document.member = 0;
    session.poll();
    CHECK(session.shows(0));
    session.document.member = kMeanMember;
    CHECK(opened.showsMember(kMeanMember));
    CHECK(opened.says("the mean of 3 members is smoother"));
    CHECK(session.heldOf(kMeanMember) != session.heldOf(0));
}

TEST_CASE("A time that a member lacks is said, and what was shown stays") {
    OpenedMembers opened;
    Session& session = opened.session;
    session.document.member = 2;
    REQUIRE(opened.showsMember(2));
    session.document.time = 2;
    CHECK(opened.until([&] { return opened.says("member mem03: has no time time 2"); }));
    CHECK(session.document.time == 0);
    CHECK(session.document.member == 2);
    session.document.member = 1;
    session.document.time = 2;
    CHECK(opened.until([&] { return session.shows(2) && session.document.time == 2; }));
}

TEST_CASE("What is shown first is a member that has the time, or a time that the member has") {
    OpenedMembers opened;
    Session& session = opened.session;
    opened.series[0]->times = 1;
    session.openAs({.named = opened.runs, .members = true, .time = 2});
    CHECK(opened.until([&] { return !session.loading() && session.document.time == 2; }));
    CHECK(session.document.member == 1);
    session.openAs({.named = opened.runs, .members = true, .memberName = "1"});
    CHECK(opened.until([&] { return !session.loading() && session.document.member == 0; }));
    CHECK(session.document.time == 0);
    session.openAs({.named = opened.runs, .members = true, .memberName = "9"});
    CHECK(opened.until([&] { return opened.says("expected: mem01, mem02, mem03 or mean"); }));
}

TEST_CASE("Steps through members are undone, and no more is held than the bound") {
    OpenedMembers opened(3);
    Session& session = opened.session;
    session.document.member = 0;
    session.history.commit(session.document);
    CHECK(session.history.undoLabel() == "Member 2 -> 1");
    CHECK(opened.showsMember(0));
    CHECK(session.undo());
    CHECK(opened.showsMember(1));
    opened.until([&] { return session.cache().count() == 3; });
    CHECK(session.cache().count() == 3);
    CHECK(session.namesMembers());
}

TEST_CASE("A member that grows is read again, and its new times are noticed") {
    OpenedMembers opened;
    Session& session = opened.session;
    for (const auto& series : opened.series) series->times = 4;
    std::ofstream(opened.runs[0], std::ios::app) << "more";
    CHECK(opened.until([&] { return session.info()->times.size() == 4; }));
    CHECK(opened.says("1 new time, up to time 3"));
    CHECK(session.ensemble()->timeIn(2, 3).has_value());
    session.document.time = 3;
    CHECK(opened.until([&] { return session.shows(3) && session.document.time == 3; }));
}

TEST_CASE("A session file keeps an ensemble and its member, and older ones are single runs") {
    const TemporaryFolder folder;
    SessionState state;
    state.slots.resize(1);
    state.slots[0].data = {(folder / "run/mem01").string(), (folder / "run/mem*2").string()};
    state.slots[0].members = true;
    state.slots[0].document.member = kMeanMember;
    std::vector<std::string> warnings;
    const std::string text = formatSession(state, folder.path());
    CHECK(contains(text, "\"member\": \"mean\""));
    CHECK(parseSession(text, "", folder.path(), warnings) == state);
    state.slots[0].document.member = 4;
    CHECK(parseSession(formatSession(state, folder.path()), "", folder.path(), warnings) == state);
    CHECK(warnings.empty());
    const std::string old =
        R"({"type": "nephoscope-session", "version": 1, "slots": [{"member": "other"}]})";
    CHECK_THROWS_WITH_AS(parseSession(old, "my", folder.path(), warnings),
                         doctest::Contains("\"mean\" or a whole number"), Error);
}

TEST_CASE(
    "Patterns of members are looked for when data have moved, and recent ones are opened so") {
    const TemporaryFolder folder;
    for (const char* name : {"mem01", "mem02"}) std::ofstream(folder / name) << "x";
    SessionState state;
    state.slots.resize(1);
    state.slots[0].members = true;
    state.slots[0].data = {(folder / "mem*1").string(), (folder / "mem*3").string()};
    CHECK(missingData(state) == std::vector{(folder / "mem*3").string()});

    const std::vector<std::string> runs{(folder / "mem01").string(), (folder / "mem*2").string()};
    const std::string entry = recentEntry(runs, true);
    CHECK(namesRuns(entry));
    CHECK(namesIn(entry) == runs);
    CHECK(isThere(entry));
    CHECK(labelOf(entry).name == "Ensemble: mem01 and 1 more");
    CHECK_FALSE(namesRuns(recentEntry(std::array{runs[0]})));
}
