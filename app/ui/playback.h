// playback.h: running through the times of the data, or along the camera path.
#pragma once

namespace neph::ui {

struct Playback {
    bool playing = false;
    bool alongPath = false;  ///< the camera path leads, and the times with it where it says so
    bool loop = true;
    double timesPerSecond = 4.0;
    int step = 1;
    double atS = 0.0;  ///< along the camera path
};

}  // namespace neph::ui
