// output_state.h: what the output panel keeps between frames: the settings of an export and the one
// that runs.
#pragma once

namespace neph::ui {

struct OutputState {
    bool open = false;  ///< the dialogue is shown
};

}  // namespace neph::ui
