// session_state.h: the contents of a session file: the documents and the names of their data.
//
// Plain values. Images, volumes and history are not included: they are computed again.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/grid/boxes.h"
#include "core/look/old_metres.h"
#include "core/session/history.h"
#include "core/volume/read_plan.h"

namespace neph {

/// One of the two documents that can be compared.
struct SlotState {
    std::vector<std::string> data;  ///< files or folders as named; empty: bundled storm
    std::optional<BoxM> region;
    std::string presetName;  ///< last loaded or saved
    Document document;
    FieldSet inMetres = 0;  ///< of the look: whose noise scale awaits bringToCells()
    bool members = false;   ///< `data` names the runs of an ensemble
    bool operator==(const SlotState&) const = default;
};

/// How two slots share the image: one alone, side by side, alternating, or as the error of A
/// against B. Session files contain only the first two.
enum class CompareMode : int { single, split, flicker, error };

/// Everything in a session file.
struct SessionState {
    std::vector<SlotState> slots;  ///< one or two
    int active = 0;                ///< the slot that panels edit
    CompareMode compare = CompareMode::single;
    float splitAt = 0.5f;  ///< share of the image width that slot A takes
    bool linkedCameras = true;
    bool linkedTimes = true;
    bool operator==(const SessionState&) const = default;
};

}  // namespace neph
