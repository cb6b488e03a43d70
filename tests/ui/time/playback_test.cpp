// playback_test.cpp: which time comes next and when, without a window or data.
#include "app/ui/time/playback.h"

#include <doctest/doctest.h>

#include <vector>

using namespace neph;

namespace {

ui::Playback playing(double timesPerSecond, bool loop) {
    ui::Playback playback;
    playback.playing = true;
    playback.timesPerSecond = timesPerSecond;
    playback.loop = loop;
    return playback;
}

/// The times that are shown in `frames` frames of `seconds` each, from `time`, of five.
std::vector<int> shown(ui::Playback& playback, int time, int frames, double seconds) {
    std::vector<int> times;
    for (int i = 0; i < frames; ++i) {
        if (const auto next = ui::advance(playback, seconds, time, 5, true)) {
            time = *next;
            times.push_back(time);
        }
    }
    return times;
}

}  // namespace

TEST_CASE("Playing goes on by a step as often as its speed says, and begins again in a loop") {
    ui::Playback playback = playing(4.0, true);
    CHECK(shown(playback, 2, 10, 0.125) == std::vector{3, 4, 0, 1, 2});  // 1.25 s
    playback = playing(4.0, true);
    playback.step = 2;
    CHECK(shown(playback, 0, 4, 0.25) == std::vector{2, 4, 0, 2});
}

TEST_CASE("Without a loop playing ends at the last time, whatever the step") {
    ui::Playback playback = playing(10.0, false);
    playback.step = 3;
    CHECK(shown(playback, 0, 2, 0.1) == std::vector{3, 4});
    CHECK(playback.playing);
    CHECK(shown(playback, 4, 1, 0.1).empty());
    CHECK_FALSE(playback.playing);
}

TEST_CASE("However late a frame is, no time is passed over") {
    ui::Playback playback = playing(8.0, false);
    CHECK(shown(playback, 0, 3, 2.0) == std::vector{1, 2, 3});
}

TEST_CASE("Playing waits for what is not there yet, and the wait is not made up for") {
    ui::Playback playback = playing(4.0, true);
    for (int i = 0; i < 100; ++i) CHECK_FALSE(ui::advance(playback, 0.1, 1, 5, false).has_value());
    CHECK(playback.playing);
    CHECK_FALSE(ui::advance(playback, 0.2, 1, 5, true).has_value());
    CHECK(ui::advance(playback, 0.05, 1, 5, true) == 2);
}

TEST_CASE("Playing ends at a time that could not be had, and not where the user went elsewhere") {
    ui::Playback playback = playing(4.0, true);
    CHECK(ui::advance(playback, 0.25, 1, 5, true) == 2);
    CHECK(ui::advance(playback, 0.25, 4, 5, true) == 0);               // the user went to 4
    CHECK_FALSE(ui::advance(playback, 0.25, 4, 5, true).has_value());  // 0 was refused
    CHECK_FALSE(playback.playing);
    playback.playing = true;
    CHECK_FALSE(ui::advance(playback, 0.25, 0, 1, true).has_value());  // nothing to play
    CHECK_FALSE(playback.playing);
}

TEST_CASE("Speeds double and halve within what can be seen") {
    ui::Playback playback;
    ui::changeSpeed(playback, 1);
    CHECK(playback.timesPerSecond == 8.0);
    ui::changeSpeed(playback, -2);
    CHECK(playback.timesPerSecond == 2.0);
    ui::changeSpeed(playback, 20);
    CHECK(playback.timesPerSecond == 32.0);
    ui::changeSpeed(playback, -20);
    CHECK(playback.timesPerSecond == 0.125);
}

TEST_CASE("A camera path is played in its own seconds, from its end to its start in a loop") {
    ui::Playback playback = playing(4.0, true);
    ui::advanceAlong(playback, 7.5, 8.0, true);
    CHECK(playback.atS == 7.5);
    ui::advanceAlong(playback, 1.0, 8.0, false);
    CHECK(playback.atS == 7.5);
    ui::advanceAlong(playback, 1.0, 8.0, true);
    CHECK(playback.atS == 0.5);
    playback.loop = false;
    ui::advanceAlong(playback, 100.0, 8.0, true);
    CHECK(playback.atS == 8.0);
    CHECK_FALSE(playback.playing);
}
