// settings.h: what is remembered between runs, in $XDG_CONFIG_HOME/nephoscope/settings.json.
#pragma once
#include <string>
#include <vector>

namespace neph {

struct Settings {
    std::string memory;  ///< as parseMemory of memory_setting.h; empty: the program chooses
    bool operator==(const Settings&) const = default;
};

/// Settings as remembered, or those of a first run. What is wrong is left out and told in
/// `warnings`.
Settings loadSettings(std::vector<std::string>& warnings);

/// Remembers; keys that this version does not know stay. Throws Error.
void saveSettings(const Settings& settings);

}  // namespace neph
