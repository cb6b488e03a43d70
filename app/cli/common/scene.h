// scene.h: what the command line asks to be shown, made into files, times and a document.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/gl/context.h"
#include "core/base/error.h"
#include "core/dataset/dataset.h"
#include "core/session/history.h"
#include "core/volume/read_plan.h"

namespace neph {

/// A fault of the command line itself; exit status 2.
class UsageError : public Error {
  public:
    using Error::Error;
};

/// Options that the workbench and `render` share, as typed.
struct SceneOptions {
    std::vector<std::string> files;        ///< files or folders; none for the bundled storm
    std::vector<std::string> readers;      ///< libraries or folders, before those found elsewhere
    std::string preset;                    ///< name or file; empty for `default`
    std::string parts;                     ///< of it, as parsePresetParts; empty for all
    std::vector<std::string> assignments;  ///< id=value
    std::string camera;                    ///< preset name or file; empty for the preset's
    std::string time;                      ///< INDEX, a:b or all; empty for the default time
    std::string region;                    ///< as parseRegion; empty for the whole domain
    std::string memory;                    ///< as parseMemory; empty for what is remembered
    std::string script;                    ///< of the workbench: a file of commands to play
};

struct Scene {
    std::string presetName;
    Document document;
    std::vector<std::string> warnings;
};

/// Look and camera of the options, upon those of `start` where given; the time is left as it is.
/// Throws Error or UsageError.
Scene makeScene(const SceneOptions& options, const std::optional<Scene>& start = {});

/// Indices named by `text`: a number (negative counts from the end), a:b (both included), all, or
/// empty for the default time. Throws UsageError naming the times there are.
std::vector<int> parseTimes(const std::string& text, const DatasetInfo& info);

/// The first of the times in `text`, before the data are open; none when it is empty. Negative
/// counts from the end. Throws UsageError.
std::optional<int> parseFirstTime(const std::string& text);

/// Part of the domain from "x0:x1,y0:y1[,z0:z1]" in km; all levels without the last pair. None when
/// `text` is empty. Throws UsageError.
std::optional<Region> parseRegion(const std::string& text);

/// What a renderer may take for volumes on this device.
std::uint64_t rendererBytes(const gl::DeviceMemory& device);

/// Bounds of volumes: as `memory` says, else as remembered, else a share of what is free. Adds to
/// `warnings` what is wrong with the remembered one. Throws UsageError.
MemoryBudget chooseBudget(const std::string& memory, std::uint64_t gpuBytes,
                          std::vector<std::string>& warnings);

}  // namespace neph
