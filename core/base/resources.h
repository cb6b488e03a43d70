// resources.h: where presets, samples and shaders lie, and what this build is called.
//
// Looked for under $NEPHOSCOPE_DATA_DIR, then <program>/../share/nephoscope, then the source tree
// that this build was made from; the first that holds the wanted path wins.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace neph {

/// The first place that holds `relative` ("presets", "samples/supercell"); none when there is none.
std::optional<std::filesystem::path> findResource(std::string_view relative);

/// As findResource; throws Error that lists the places looked at.
std::filesystem::path resourcePath(std::string_view relative);

/// Directory of the running program.
std::filesystem::path programDir();

/// Where the readers of this installation lie, or those of the build tree.
std::filesystem::path ownReaderDir();

/// $XDG_DATA_HOME/nephoscope or ~/.local/share/nephoscope; none without a home.
std::optional<std::filesystem::path> userDataDir();

/// $XDG_CACHE_HOME/nephoscope or ~/.cache/nephoscope; none without a home.
std::optional<std::filesystem::path> userCacheDir();

/// $XDG_CONFIG_HOME/nephoscope or ~/.config/nephoscope; none without a home.
std::optional<std::filesystem::path> userConfigDir();

/// $XDG_STATE_HOME/nephoscope or ~/.local/state/nephoscope; none without a home.
std::optional<std::filesystem::path> userStateDir();

/// For example "0.1.0".
std::string_view versionText();

}  // namespace neph
