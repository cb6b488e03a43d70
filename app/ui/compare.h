// compare.h: two slots, A and B, each with data, look and camera of its own, and how they share the
// picture.
#pragma once
#include "core/session_state.h"

namespace neph::ui {

struct CompareState {
    int active = 0;        ///< slot that panels edit and keys act on
    bool second = false;   ///< slot B exists
    bool peeking = false;  ///< the other slot is shown for as long as Shift is held
    CompareMode mode = CompareMode::single;
    float splitAt = 0.5f;  ///< share of the picture's width that A takes
    bool linkedCameras = true, linkedTimes = true;
    int wanted = -1;     ///< slot to go to after this frame; -1: none
    bool close = false;  ///< give up B after this frame
};

}  // namespace neph::ui
