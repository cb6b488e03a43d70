// presets_command.h: `nephoscope presets`: what there is, what is in it, whether it is right, and
// the user's own saved, copied, renamed and deleted.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/cli/common/scene.h"

namespace neph {

enum class PresetsAction {
    list,
    show,
    check,
    diff,
    parameters,
    save,
    duplicate,
    rename,
    describe,
    remove
};

struct PresetsRequest {
    PresetsAction action = PresetsAction::list;
    std::string preset;  ///< name or file
    std::string other;   ///< to compare with, or a new name
    std::vector<std::string> several;
    std::optional<std::string> title, description;
    bool replace = false;
    SceneRequest scene;  ///< look and camera of what is saved
};

/// Throws Error. `check` gives 1 where a file is wrong or has unknown keys, all else 0.
int runPresets(const PresetsRequest& request);

/// The reference page, in Markdown, from the look table.
std::string parameterReference();

}  // namespace neph
