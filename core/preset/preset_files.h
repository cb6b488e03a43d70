// preset_files.h: saves, duplicates, renames, describes and deletes preset files.
//
// Only the user's own presets can be changed. Nothing is replaced unless requested.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/preset/preset.h"

namespace neph {

/// The preset of that name. Throws Error with the nearest name.
PresetEntry presetEntry(std::string_view name);

/// The name of a listed preset, given by name or by file; otherwise the path of the file, so that
/// it is never mistaken for a listed preset of the same name.
std::string presetNameOf(std::string_view nameOrFile);

/// Such a name for display: a path without folders and .json.
std::string presetLabel(const std::string& name);

/// Whether a name is in use, before something is saved under it.
enum class PresetNameUse { free, bundled, own };
PresetNameUse presetNameUse(std::string_view name);

/// `name` itself, or the first of "name 2", "name 3" that is not in use.
std::string freePresetName(std::string_view name);

/// Saves a preset of the user; returns the file. It hides a bundled preset of the same name. Throws
/// Error if the user has one of that name, unless `replace`.
std::filesystem::path saveOwnPreset(const std::string& name, const Preset& preset, bool replace);

/// Copies a preset or a file to a preset of the user, under `newName` or a free name; returns the
/// name. Throws Error if the name is in use.
std::string duplicatePreset(std::string_view nameOrFile, std::string_view newName = {});

/// Throws Error if the preset is bundled or the new name is in use.
void renamePreset(std::string_view name, std::string_view newName);

/// Changes title and description. Throws Error if the preset is bundled, or has unknown keys that
/// would be lost.
void describePreset(std::string_view name, const PresetText& text);

/// Moves a preset to the trash; returns its new path. Throws Error if it is bundled.
std::filesystem::path deletePreset(std::string_view name);

}  // namespace neph
