// palette_state.h: the searchable list of commands: what it keeps between frames.
#pragma once
#include <string>
#include <vector>

namespace neph::ui {

struct Palette {
    bool open = false;                ///< asked for; opens in the next frame
    std::string text;                 ///< as typed
    int chosen = 0;                   ///< row that Enter runs
    std::vector<std::string> recent;  ///< ids of what was run, newest first
};

}  // namespace neph::ui
