// compare_state.h: two slots, A and B, each with data, look and camera of its own, and how they
// share the image.
#pragma once
#include <array>
#include <string>

#include "core/session/session_state.h"

namespace neph::ui {

struct CompareState {
    std::array<std::string, 2> members;  ///< shown in A and B: "mem03", "mean"; empty: a single run
    int active = 0;                      ///< slot that panels edit and keys act on
    bool second = false;                 ///< slot B exists
    bool peeking = false;                ///< the other slot is shown for as long as Shift is held
    CompareMode mode = CompareMode::single;
    int flickered = 0;     ///< slot that is seen now where they are alternately
    bool figures = false;  ///< how far A is from B is told
    float splitAt = 0.5f;  ///< share of the image's width that A takes
    bool linkedCameras = true, linkedTimes = true;
    int wanted = -1;     ///< slot to go to after this frame; -1: none
    bool close = false;  ///< give up B after this frame
    bool trace = false;  ///< make B what the reference draws of A, after this frame
};

/// The slot whose image is seen where there is one at a time.
inline int seenSlot(const CompareState& compare) {
    if (compare.mode == CompareMode::flicker) return compare.flickered;
    return compare.peeking ? 1 - compare.active : compare.active;
}

/// Whether images have to be compared for what is to be seen.
inline bool comparesImages(const CompareState& compare) {
    return compare.second && (compare.figures || compare.mode == CompareMode::error);
}

}  // namespace neph::ui
