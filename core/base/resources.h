// resources.h: where presets, samples and shaders are, and the version of this build.
//
// Searched under $NEPHOSCOPE_DATA_DIR, then <program>/../share/nephoscope, then the source tree of
// this build; the first that contains the requested path wins.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace neph {

/// The first match for `relative` ("presets", "samples/supercell"); empty if there is none.
std::optional<std::filesystem::path> findResource(std::string_view relative);

/// As findResource; throws an Error that lists the places searched.
std::filesystem::path resourcePath(std::string_view relative);

/// Directory of the running program.
std::filesystem::path programDir();

/// Folder of the readers of this installation, or of the build tree.
std::filesystem::path ownReaderDir();

/// $XDG_DATA_HOME/nephoscope or ~/.local/share/nephoscope; empty without a home directory.
std::optional<std::filesystem::path> userDataDir();

/// $XDG_CACHE_HOME/nephoscope or ~/.cache/nephoscope; empty without a home directory.
std::optional<std::filesystem::path> userCacheDir();

/// $XDG_CONFIG_HOME/nephoscope or ~/.config/nephoscope; empty without a home directory.
std::optional<std::filesystem::path> userConfigDir();

/// $XDG_STATE_HOME/nephoscope or ~/.local/state/nephoscope; empty without a home directory.
std::optional<std::filesystem::path> userStateDir();

/// For example "0.1.0".
std::string_view versionText();

}  // namespace neph
