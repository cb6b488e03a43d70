// session_state.h: what a session file keeps: the documents and where their data lie.
//
// Plain values. Pictures, volumes and history are no part of it: they are made again.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/session/history.h"
#include "core/volume/read_plan.h"

namespace neph {

/// One of the two documents that can be compared.
struct SlotState {
    std::vector<std::string> data;  ///< files or folders as they were named; none: bundled storm
    std::optional<Region> region;
    std::string presetName;  ///< last loaded or saved
    Document document;
    bool operator==(const SlotState&) const = default;
};

/// How two slots share the picture: one of them alone, side by side, in turns, or as the error of A
/// against B. Session files hold the first two.
enum class CompareMode : int { single, split, flicker, error };

struct SessionState {
    std::vector<SlotState> slots;  ///< one or two
    int active = 0;                ///< the slot that panels edit
    CompareMode compare = CompareMode::single;
    float splitAt = 0.5f;  ///< share of the picture's width that slot A takes
    bool linkedCameras = true;
    bool linkedTimes = true;
    bool operator==(const SessionState&) const = default;
};

}  // namespace neph
