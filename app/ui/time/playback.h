// playback.h: running through the times of the data, or along the camera path.
#pragma once
#include <optional>

#include "core/camera/camera.h"

namespace neph::ui {

/// The document's camera before a path led it, and where the path put it last.
struct LedCamera {
    CameraPose before, now;
    glm::dvec2 movedM{0.0};  ///< RegularGrid::movedM of the grid that they are relative to
};

struct Playback {
    bool playing = false;
    bool alongPath = false;  ///< the camera path leads, and the times with it where it says so
    bool loop = true;
    double timesPerSecond = 4.0;
    int step = 1;
    double atS = 0.0;  ///< along the camera path
    std::optional<LedCamera> led;
    double sinceS = 0.0;     ///< since the last step through the times
    int from = -1, to = -1;  ///< the last step, to notice when it was refused; -1: none
};

inline constexpr double kLeastTimesPerSecond = 0.125, kMostTimesPerSecond = 32.0;

/// Twice as fast for each step, or half for each below zero.
void changeSpeed(Playback& playback, int steps);

/// The time to go to after `seconds` more, of `count`; none: stay. Nothing moves until the time
/// that is shown is `ready`, and no time is passed over however late it is. Playing ends at the
/// last time where there is no loop, and where the time asked for could not be had, which shows in
/// that `time` is the one before it again.
std::optional<int> advance(Playback& playback, double seconds, int time, int count, bool ready);

/// Moves on along a path that takes `durationS`; likewise.
void advanceAlong(Playback& playback, double seconds, double durationS, bool ready);

}  // namespace neph::ui
