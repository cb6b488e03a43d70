// palette.h: the searchable list of commands.
#pragma once
#include <string>

namespace neph::ui {

struct Palette {
    bool open = false;
    std::string text;  ///< as typed
};

}  // namespace neph::ui
