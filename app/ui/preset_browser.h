// preset_browser.h: what the browser of presets keeps between frames.
#pragma once
#include <string>
#include <vector>

#include "core/preset.h"

namespace neph::ui {

struct PresetBrowser {
    std::vector<PresetEntry> entries;  ///< as last listed
    std::vector<std::string> titles;   ///< of `entries`
    bool listed = false;
    std::string name;  ///< as typed
};

}  // namespace neph::ui
