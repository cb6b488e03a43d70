// preset.h: a look, and perhaps a camera, kept as JSON.
//
// A preset knows no data set, no path and no sampling. A file is {"type": "nephoscope-look",
// "version": 1, "title", "description", "look": {id: value}, "camera": {...}}; the ids, ranges and
// defaults are those of the look table. Files are untrusted: size, depth and duplicates are
// checked.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/camera/camera.h"
#include "core/look/look.h"

namespace neph {

struct Preset {
    std::string title;
    std::string description;
    Look look;
    std::optional<CameraPose> camera;
    bool operator==(const Preset&) const = default;
};

/// The words of a preset.
struct PresetText {
    std::string title, description;
};

struct LoadedPreset {
    Preset preset;
    std::vector<std::string> warnings;  ///< unknown keys, each with the nearest known one
    std::vector<std::string> notes;     ///< sampling that the file names, which no preset holds
};

/// Reads a preset from text; `where` opens the messages. Missing keys take their defaults. Throws
/// Error naming key, value and range.
LoadedPreset parsePreset(std::string_view text, std::string_view where);

/// Reads a preset file. Throws Error.
LoadedPreset loadPreset(const std::filesystem::path& file);

/// All parameters, in the order of the look table; reads back bit for bit.
std::string formatPreset(const Preset& preset);

/// Writes aside and renames. Throws Error when the place cannot be written.
void savePreset(const std::filesystem::path& file, const Preset& preset);

struct PresetEntry {
    std::string name;  ///< file name without .json
    std::filesystem::path file;
    bool bundled = true;  ///< otherwise the user's
};

/// Bundled presets, then the user's, each in order of name; a user's preset of a bundled name
/// stands in its place.
std::vector<PresetEntry> listPresets();

/// Changes when a preset is added, replaced or taken away.
std::filesystem::file_time_type presetsStamp();

/// A preset by name, or by file when `nameOrFile` names one. Throws Error with the nearest name.
std::filesystem::path findPreset(std::string_view nameOrFile);

/// Why this cannot be the name of a preset; empty when it can.
std::string presetNameFault(std::string_view name);

/// Where a preset of this name of the user's is kept; makes the folder. Throws Error when the name
/// cannot be that of a file.
std::filesystem::path userPresetFile(std::string_view name);

/// A camera by preset name, preset file, or file that holds the camera object alone. Throws Error;
/// what was unknown is added to `warnings`.
CameraPose loadCamera(std::string_view nameOrFile, std::vector<std::string>& warnings);

}  // namespace neph
