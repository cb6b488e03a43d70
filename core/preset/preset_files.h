// preset_files.h: what can be done with presets as files: saved, duplicated, renamed, described and
// moved to the trash.
//
// Only the user's own can be changed. Nothing is replaced unless that is asked for.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/preset/preset.h"

namespace neph {

/// The preset of that name. Throws Error with the nearest name.
PresetEntry presetEntry(std::string_view name);

/// The name of a preset that is in a list of presets by name or by file; otherwise the file's path,
/// so that it is never taken for one of the same name.
std::string presetNameOf(std::string_view nameOrFile);

/// Such a name as it is shown: a path without folders and .json.
std::string presetLabel(const std::string& name);

/// What a name stands for before something is saved under it.
enum class PresetNameUse { free, bundled, own };
PresetNameUse presetNameUse(std::string_view name);

/// `name` itself, or the first of "name 2", "name 3" that is no preset's.
std::string freePresetName(std::string_view name);

/// Saves as one of the user's; returns the file. A bundled preset of the name is hidden by it.
/// Throws Error where the user has one of that name, unless `replace`.
std::filesystem::path saveOwnPreset(const std::string& name, const Preset& preset, bool replace);

/// A copy, of a file as well, as one of the user's, under `newName` or a free name; returns the
/// name. Throws Error where there is a preset of that name.
std::string duplicatePreset(std::string_view nameOrFile, std::string_view newName = {});

/// Throws Error when it is bundled or there is a preset of the new name.
void renamePreset(std::string_view name, std::string_view newName);

/// Other words for the same look. Throws Error when it is bundled, or holds keys that would be
/// lost.
void describePreset(std::string_view name, const PresetText& text);

/// Moves it to the trash; returns where it lies. Throws Error when it is bundled.
std::filesystem::path deletePreset(std::string_view name);

}  // namespace neph
