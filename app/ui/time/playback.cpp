// playback.cpp: which time or place on the path comes next, and when.
#include "app/ui/time/playback.h"

#include <algorithm>
#include <cmath>

namespace neph::ui {
namespace {

/// The time after `time`, or none where playing ends.
std::optional<int> after(const Playback& playback, int time, int count) {
    const int last = count - 1;
    if (time + playback.step <= last) return time + playback.step;
    if (playback.loop) return 0;
    if (time < last) return last;
    return {};
}

void stop(Playback& playback) {
    playback.playing = false;
    playback.sinceS = 0.0;
    playback.from = playback.to = -1;
}

}  // namespace

void changeSpeed(Playback& playback, int steps) {
    playback.timesPerSecond = std::clamp(playback.timesPerSecond * std::exp2(steps),
                                         kLeastTimesPerSecond, kMostTimesPerSecond);
}

std::optional<int> advance(Playback& playback, double seconds, int time, int count, bool ready) {
    const bool refused = playback.to >= 0 && time == playback.from && time != playback.to;
    if (count < 2 || refused) {
        stop(playback);
        return {};
    }
    if (!ready) return {};
    playback.sinceS += seconds;
    const double interval = 1.0 / playback.timesPerSecond;
    if (playback.sinceS < interval) return {};
    // A late step delays those after it: to catch up would be to pass times over.
    playback.sinceS = std::fmod(playback.sinceS, interval);
    const std::optional<int> next = after(playback, time, count);
    if (!next) {
        stop(playback);
        return {};
    }
    playback.from = time;
    playback.to = *next;
    return next;
}

void advanceAlong(Playback& playback, double seconds, double durationS, bool ready) {
    if (durationS <= 0.0) stop(playback);
    if (!playback.playing || !ready) return;
    playback.atS += seconds;
    if (playback.atS < durationS) return;
    if (playback.loop) {
        playback.atS = std::fmod(playback.atS, durationS);
    } else {
        playback.atS = durationS;
        stop(playback);
    }
}

}  // namespace neph::ui
