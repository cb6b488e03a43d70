// output_state.h: what the export dialogue keeps between frames: its settings and the export that
// runs.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/session/export_job.h"

namespace neph::ui {

enum class ExportWhat : int { image, times, path };
enum class ExportFormat : int { png, exr, mp4 };
enum class ExportSize : int { window, hd, uhd, own };

struct ExportSettings {
    ExportWhat what = ExportWhat::image;
    ExportFormat format = ExportFormat::png;
    ExportSize size = ExportSize::window;
    glm::ivec2 ownPx{1920, 1080};
    int supersample = 1;
    int samples = 16;
    bool transparent = false;
    bool bothSides = true;  ///< where the window shows two
    double fps = 25.0;      ///< of videos and paths
    std::string file;       ///< as typed; empty before the dialogue was opened
};

struct OutputState {
    bool open = false;  ///< the dialogue is shown
    ExportSettings settings;
    std::optional<ExportJob> job;      ///< runs, or has ended and was not yet closed
    std::filesystem::path session;     ///< what the job reads; removed with it
    std::filesystem::path program;     ///< that exports; empty: this one
    bool asksToQuit = false;           ///< what becomes of the job when the window closes
    bool quitsAfter = false;           ///< the window closes when the job is done
    bool mayQuit = false;              ///< that was answered
    std::vector<std::string> readers;  ///< that this program was told of
};

}  // namespace neph::ui
