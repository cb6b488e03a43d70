// scene.h: what is to be shown, as asked for on the command line, made into times and a document.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/common/usage.h"
#include "app/gl/context.h"
#include "core/dataset/dataset.h"
#include "core/grid/boxes.h"
#include "core/preset/preset_difference.h"
#include "core/session/history.h"
#include "core/volume/read_plan.h"

namespace neph {

/// Indices of times, both included; negative ones count from the end.
struct TimeRange {
    int first = 0, last = 0;
    std::string typed;  ///< for messages: "--time 1:2"
};

/// A value for one parameter, and the option that asks for it.
struct Setting {
    std::string option;
    const Parameter* row = nullptr;
    ParameterValue value;
};

/// What the workbench and the commands that render share. What is left empty is as the preset, or
/// the session, has it.
struct SceneRequest {
    std::vector<std::string> files;       ///< files or folders; none: the bundled storm
    std::vector<std::string> members;     ///< runs of an ensemble, in place of files
    std::string member;                   ///< that is shown, as Ensemble::memberNamed; or empty
    std::vector<std::string> readers;     ///< libraries or folders, before those found elsewhere
    std::string map;                      ///< of the variables of an unknown file; or empty
    std::string preset;                   ///< name or file
    PresetParts parts = kPresetAll;       ///< of the preset
    std::vector<Setting> settings;        ///< of --set
    std::vector<Setting> engineSettings;  ///< of options of their own, after those; see checkActing
    std::string camera;                   ///< preset name or file
    std::optional<TimeRange> times;       ///< none: the default time
    std::optional<BoxM> region;           ///< none: the whole domain
    std::string memory;                   ///< as parseMemory; empty: as remembered
};

/// The window.
struct WorkbenchRequest {
    SceneRequest scene;
    std::string script;  ///< file of commands to play; empty: none
};

struct Scene {
    std::string presetName;
    Document document;
    std::vector<std::string> warnings;
    FieldSet inMetres = 0;     ///< of the look: whose noise scale awaits bringToCells()
    bool cameraAsked = false;  ///< else the data decide where the camera stands
};

/// Look and camera of the request, upon those of `start` where given; the time is left as it is.
/// Throws Error.
Scene makeScene(const SceneRequest& request, const std::optional<Scene>& start = {});

/// Throws UsageError where an option acts `with` none of `engines`; both are bits.
void checkActing(const std::string& option, unsigned with, unsigned engines);

/// "light.form=printed" as a setting. Throws UsageError.
Setting parseSetting(const std::string& option, std::string_view assignment);

/// A value of the parameter that `option` stands for, typed as the screen shows it. Throws
/// UsageError.
Setting parseAlias(const std::string& option, const std::string& text);

/// Throws UsageError where two settings are of one parameter.
void checkSetOnce(const std::vector<Setting>& settings);

/// "INDEX", "a:b" or "all". Throws UsageError.
TimeRange parseTimeRange(const std::string& option, const std::string& text);

/// Opens files, or the ensemble of `members` where there are any. Throws Error or Cancelled.
std::shared_ptr<Dataset> openData(const std::vector<std::string>& files,
                                  const std::vector<std::string>& members, const PluginHost& host,
                                  const Progress& progress = {});

/// The member that is asked for by --member, or `otherwise` as far as there is such a one. Throws
/// UsageError where there is none of that name, or no ensemble.
int memberOf(const Dataset& dataset, const std::string& asked, int otherwise);

/// The indices of a range, or of the default time where there is none. Throws UsageError that names
/// the times there are.
std::vector<int> timesOf(const std::optional<TimeRange>& range, const DatasetInfo& info);

/// Part of the domain from "x0:x1,y0:y1[,z0:z1]" in km; all levels without the last pair. Throws
/// UsageError.
BoxM parseRegion(const std::string& text);

/// What a renderer may take for volumes on this device.
std::uint64_t rendererBytes(const gl::DeviceMemory& device);

/// Bounds of volumes: as `memory` says, else as remembered, else a share of what is free. Adds to
/// `warnings` what is wrong with the remembered one. Throws UsageError.
MemoryBudget chooseBudget(const std::string& memory, std::uint64_t gpuBytes,
                          std::vector<std::string>& warnings);

}  // namespace neph
