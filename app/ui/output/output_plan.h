// output_plan.h: what an export would do, and the command line that does it: the dialogue without
// its widgets.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "app/ui/output/output_state.h"
#include "core/session/session.h"

namespace neph::ui {

/// What of the window an export depends on.
struct ExportScene {
    glm::ivec2 windowPx{1280, 720};  ///< size of the image in the window
    int slot = 1;                    ///< 1 or 2
    bool split = false;              ///< the window shows both
    std::vector<std::string> readers;
    bool averages = true;  ///< the march draws: the number of samples acts
};

/// Size of the images.
glm::ivec2 sizeOf(const ExportSettings& settings, const ExportScene& scene);

/// Arguments of the program for what `settings` say, of the scene in the session file, to `out`.
std::vector<std::string> exportArguments(const ExportSettings& settings, const ExportScene& scene,
                                         const std::filesystem::path& session,
                                         const std::filesystem::path& out);

/// Why an export cannot be as the settings say, in a sentence; empty when it can.
std::string exportFault(const ExportSettings& settings, const Session& session);

/// The images folder of the user's, else where the program was started, with a name.
std::filesystem::path defaultExportFile();

/// `file` with the ending of the format.
std::filesystem::path withEnding(std::filesystem::path file, ExportFormat format);

/// `file`, or a name with a number added, so that nothing is there already: no such file, nor, for
/// a series, any image of it.
std::filesystem::path freeFile(const std::filesystem::path& file, bool series);

}  // namespace neph::ui
