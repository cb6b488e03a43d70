// presets_command.h: `nephoscope presets`: what there is, what is in it, whether it is right, and
// the user's own saved, copied, renamed and deleted.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/common/scene.h"

namespace neph {

struct PresetsOptions {
    std::string preset;  ///< name or file
    std::string other;   ///< to compare with, or a new name
    std::vector<std::string> several;
    std::optional<std::string> title, description;
    bool replace = false;
    SceneOptions scene;  ///< of what is saved
};

/// Carries out a subcommand: list, show, check, parameters, diff, save, duplicate, rename, describe
/// or delete. Throws Error. `check` gives 1 where a file is wrong or has unknown keys.
int runPresets(std::string_view subcommand, const PresetsOptions& options);

/// The reference page, in Markdown, from the look table.
std::string parameterReference();

}  // namespace neph
