// settings.h: what is remembered between runs, in $XDG_CONFIG_HOME/nephoscope/settings.json.
#pragma once
#include <string>
#include <vector>

namespace neph {

enum class Theme : int { dark, light };

struct Settings {
    std::string memory;  ///< as parseMemory of memory_setting.h; empty: the program chooses
    Theme theme = Theme::dark;
    float textScale = 1.0f;         ///< of text and panels, besides the monitor's own scale
    double framesPerSecond = 30.0;  ///< to be held while something moves
    bool leftColumn = true, rightColumn = true;
    bool scaleBar = true, compass = true, heightRuler = false;  ///< over the picture
    std::vector<std::string> recent;  ///< data and sessions opened, newest first, absolute paths
    bool operator==(const Settings&) const = default;
};

/// Settings as remembered, or those of a first run. What is wrong is left out and told in
/// `warnings`.
Settings loadSettings(std::vector<std::string>& warnings);

/// Remembers; keys that this version does not know stay. Throws Error.
void saveSettings(const Settings& settings);

}  // namespace neph
