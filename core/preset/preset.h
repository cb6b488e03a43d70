// preset.h: a look, and optionally a camera, saved as JSON.
//
// A preset does not depend on a data set or a camera path, and says nothing of sampling. A file is
// {"type": "nephoscope-look", "version": 1, "title", "description", "look": {id: value},
// "camera": {...}}; the ids, ranges and defaults are those of the look table. Files are untrusted:
// size, depth and duplicate keys are
// checked.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/camera/camera.h"
#include "core/look/look.h"
#include "core/look/old_metres.h"

namespace neph {

/// The contents of a preset file.
struct Preset {
    std::string title;
    std::string description;
    Look look;
    std::optional<CameraPose> camera;
    bool operator==(const Preset&) const = default;
};

/// Title and description of a preset.
struct PresetText {
    std::string title, description;
};

/// A preset and the complaints about its file.
struct LoadedPreset {
    Preset preset;
    std::vector<std::string> warnings;  ///< unknown keys, each with the nearest known one
    FieldSet inMetres = 0;              ///< whose noise scale awaits bringToCells()
    std::vector<std::string>
        notes;  ///< metres, and sampling that the file names, which no preset holds
};

/// Reads a preset from text; `where` starts the messages. Missing keys get their defaults. Throws
/// Error naming key, value and range.
LoadedPreset parsePreset(std::string_view text, std::string_view where);

/// Reads a preset file. Throws Error.
LoadedPreset loadPreset(const std::filesystem::path& file);

/// All parameters, in the order of the look table; reading it back gives the same bits.
std::string formatPreset(const Preset& preset);

/// Replaces the file. Throws Error if it cannot be written.
void savePreset(const std::filesystem::path& file, const Preset& preset);

/// A preset in the list.
struct PresetEntry {
    std::string name;  ///< file name without .json
    std::filesystem::path file;
    bool bundled = true;  ///< otherwise it is the user's
};

/// Bundled presets, then the user's, each sorted by name; a user's preset with the name of a
/// bundled one replaces it.
std::vector<PresetEntry> listPresets();

/// Changes when a preset is added, replaced or removed.
std::filesystem::file_time_type presetsStamp();

/// The file of a preset, by name or by path. Throws Error with the nearest name.
std::filesystem::path findPreset(std::string_view nameOrFile);

/// Why this cannot be the name of a preset; empty if it can.
std::string presetNameFault(std::string_view name);

/// File of the user's preset with this name; creates the folder. Throws Error if it is not a valid
/// file name.
std::filesystem::path userPresetFile(std::string_view name);

/// A camera by preset name, preset file, or file with only a camera object. Throws Error; unknown
/// keys are added to `warnings`.
CameraPose loadCamera(std::string_view nameOrFile, std::vector<std::string>& warnings);

}  // namespace neph
