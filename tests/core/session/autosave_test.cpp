// autosave_test.cpp: what is left of a session after every kind of end.
#include "core/session/autosave.h"

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

#include "core/session/session_file.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;

SessionState at(int time) {
    SessionState state;
    state.slots.resize(1);
    state.slots[0].document.time = time;
    return state;
}

/// Shows states to an autosave, one an interval.
class Hand {
  public:
    explicit Hand(Autosave& autosave) : autosave_(autosave) {}

    void show(const SessionState& state) {
        now_ += std::chrono::seconds(6);
        autosave_.tick([&] { return state; }, now_);
        autosave_.wait();
    }

  private:
    Autosave& autosave_;
    Autosave::Clock::time_point now_ = Autosave::Clock::now();
};

int filesIn(const fs::path& folder) {
    return static_cast<int>(std::distance(fs::directory_iterator(folder), {}));
}

/// A window of another process, killed after it has shown these times.
void showAndKill(const fs::path& folder, std::initializer_list<int> times) {
    int told[2];
    REQUIRE(::pipe(told) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
        Autosave autosave(folder);
        Hand hand(autosave);
        for (const int time : times) hand.show(at(time));
        (void)!::write(told[1], "x", 1);
        ::pause();
        ::_exit(0);
    }
    char byte = 0;
    CHECK(::read(told[0], &byte, 1) == 1);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(told[0]);
    ::close(told[1]);
}

}  // namespace

TEST_CASE("After kill -9 the session as last saved is offered, once, and to one window alone") {
    const TemporaryFolder folder;
    showAndKill(folder.path(), {0, 3, 7});
    {
        const Autosave first(folder.path());
        REQUIRE(first.crashed() != nullptr);
        CHECK(loadSession(first.crashed()->file) == at(7));
        CHECK(std::time(nullptr) - first.crashed()->savedAt < 60);
        const Autosave second(folder.path());
        CHECK(second.crashed() == nullptr);
    }
    Autosave later(folder.path());  // nobody has decided
    REQUIRE(later.crashed() != nullptr);
    later.discardCrashed();
    CHECK(later.crashed() == nullptr);
    CHECK(Autosave(folder.path()).crashed() == nullptr);
}

TEST_CASE("A session that was taken over is kept until the new window has saved its own") {
    const TemporaryFolder folder;
    showAndKill(folder.path(), {0, 3});
    {
        Autosave autosave(folder.path());
        REQUIRE(autosave.crashed() != nullptr);
        autosave.adoptCrashed();
        CHECK(autosave.crashed() != nullptr);
    }
    Autosave autosave(folder.path());
    Hand hand(autosave);
    hand.show(at(0));
    REQUIRE(autosave.crashed() != nullptr);
    const SessionState restored = loadSession(autosave.crashed()->file);
    autosave.adoptCrashed();
    hand.show(restored);
    CHECK(autosave.crashed() == nullptr);
    autosave.finish(restored);
    REQUIRE(autosave.last().has_value());
    CHECK(loadSession(autosave.last()->file) == at(3));
}

TEST_CASE("After a proper end the session can be opened again, and none is called crashed") {
    const TemporaryFolder folder;
    {
        Autosave autosave(folder.path());
        CHECK_FALSE(autosave.last().has_value());
        Hand hand(autosave);
        hand.show(at(0));
        hand.show(at(1));
        autosave.finish(at(2));
    }
    CHECK(filesIn(folder.path()) == 1);
    const Autosave next(folder.path());
    CHECK(next.crashed() == nullptr);
    REQUIRE(next.last().has_value());
    CHECK(loadSession(next.last()->file) == at(2));
}

TEST_CASE(
    "A window in which nothing was done leaves the last session alone, and nothing beside it") {
    const TemporaryFolder folder;
    {
        Autosave autosave(folder.path());
        Hand hand(autosave);
        hand.show(at(5));
        hand.show(at(6));
        autosave.finish(at(6));
    }
    Autosave idle(folder.path());
    Hand hand(idle);
    hand.show(at(0));
    hand.show(at(0));
    idle.finish(at(0));
    CHECK(loadSession(idle.last()->file) == at(6));
    { const Autosave another(folder.path()); }
    CHECK(filesIn(folder.path()) == 2);  // the last session, and the lock of `idle`
}

TEST_CASE("Changes are saved once an interval and not otherwise") {
    const TemporaryFolder folder;
    Autosave autosave(folder.path());
    int asked = 0;
    const auto start = Autosave::Clock::now();
    const auto tick = [&](double afterS, int time) {
        autosave.tick(
            [&] {
                ++asked;
                return at(time);
            },
            start + std::chrono::milliseconds(static_cast<int>(1000.0 * afterS)));
        autosave.wait();
    };
    tick(0.0, 0);
    tick(4.9, 1);
    CHECK(asked == 1);
    CHECK(filesIn(folder.path()) == 1);  // the lock
    tick(5.1, 2);
    CHECK(asked == 2);
    CHECK(filesIn(folder.path()) == 2);
    const auto written = [&] {
        for (const auto& item : fs::directory_iterator(folder.path())) {
            if (item.path().extension() == ".json") return fs::last_write_time(item.path());
        }
        return fs::file_time_type();
    };
    const auto before = written();
    tick(11.0, 2);
    CHECK(asked == 3);
    CHECK(written() == before);
}

TEST_CASE("Two windows keep two sessions") {
    const TemporaryFolder folder;
    showAndKill(folder.path(), {0, 1});
    {
        Autosave running(folder.path());
        running.discardCrashed();
        Hand hand(running);
        hand.show(at(0));
        hand.show(at(2));
        showAndKill(folder.path(), {0, 3});
        const Autosave third(folder.path());
        REQUIRE(third.crashed() != nullptr);
        CHECK(loadSession(third.crashed()->file) == at(3));
    }
    Autosave both(folder.path());
    REQUIRE(both.crashed() != nullptr);
    both.discardCrashed();
    CHECK(both.crashed() != nullptr);
}

TEST_CASE("A folder that cannot be written is told once, and nothing else happens") {
    Autosave autosave("/dev/null/state");
    const auto fault = autosave.takeFault();
    REQUIRE(fault.has_value());
    CHECK(contains(*fault, "/dev/null/state"));
    CHECK_FALSE(autosave.takeFault().has_value());
    Hand hand(autosave);
    hand.show(at(0));
    hand.show(at(1));
    autosave.finish(at(1));
    Autosave none(std::nullopt);
    CHECK_FALSE(none.takeFault().has_value());
    CHECK_FALSE(none.last().has_value());
}

TEST_CASE("A save that fails is told, and tried again until it succeeds") {
    const TemporaryFolder folder;
    const fs::path place = folder / "state";
    Autosave autosave(place);
    Hand hand(autosave);
    hand.show(at(0));
    fs::remove_all(place);
    hand.show(at(1));
    CHECK(autosave.takeFault().has_value());
    hand.show(at(1));
    CHECK_FALSE(autosave.takeFault().has_value());  // the same one
    fs::create_directories(place);
    hand.show(at(1));
    CHECK(filesIn(place) == 1);
}
