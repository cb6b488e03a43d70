// preset_files.cpp: checks the rules first, then changes the file.
#include "core/preset/preset_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/trash.h"

namespace neph {
namespace {

std::optional<PresetEntry> entryOf(std::string_view name) {
    for (PresetEntry& entry : listPresets()) {
        if (entry.name == name) return std::move(entry);
    }
    return {};
}

/// The entry of a preset that belongs to the user; throws Error for a bundled one.
PresetEntry ownEntry(std::string_view name, std::string_view cannot) {
    PresetEntry entry = presetEntry(name);
    if (entry.bundled) {
        throw Error({"", fmt::format("the bundled preset {} cannot be {}", name, cannot), "", "",
                     "duplicate it, and change the copy"});
    }
    return entry;
}

/// Bundled names are taken too: a copy should not hide a bundled preset by accident.
void refuseTaken(std::string_view name) {
    if (!entryOf(name)) return;
    throw Error({"", fmt::format("there is a preset {} already", name), "", "a name that is free",
                 fmt::format("for example {}", freePresetName(name))});
}

}  // namespace

PresetEntry presetEntry(std::string_view name) {
    if (auto entry = entryOf(name)) return *std::move(entry);
    const std::filesystem::path file = findPreset(name);  // throws if there is no such file
    throw Error({"", fmt::format("{} is no preset of the list, but a file", name), "",
                 "a name that nephoscope presets lists", ""});
}

std::string presetNameOf(std::string_view nameOrFile) {
    const std::vector<PresetEntry> entries = listPresets();
    if (std::ranges::find(entries, nameOrFile, &PresetEntry::name) != entries.end()) {
        return std::string(nameOrFile);
    }
    std::error_code fault;
    for (const PresetEntry& entry : entries) {
        if (std::filesystem::equivalent(entry.file, nameOrFile, fault)) return entry.name;
    }
    return std::filesystem::absolute(nameOrFile, fault).string();
}

std::string presetLabel(const std::string& name) {
    return name.find('/') == name.npos ? name : std::filesystem::path(name).stem().string();
}

PresetNameUse presetNameUse(std::string_view name) {
    const auto entry = entryOf(name);
    if (!entry) return PresetNameUse::free;
    return entry->bundled ? PresetNameUse::bundled : PresetNameUse::own;
}

std::string freePresetName(std::string_view name) {
    const std::vector<PresetEntry> entries = listPresets();
    std::string candidate(name);
    for (int i = 2; std::ranges::find(entries, candidate, &PresetEntry::name) != entries.end();
         ++i) {
        candidate = fmt::format("{} {}", name, i);
    }
    return candidate;
}

std::filesystem::path saveOwnPreset(const std::string& name, const Preset& preset, bool replace) {
    std::filesystem::path file = userPresetFile(name);
    if (!replace && presetNameUse(name) == PresetNameUse::own) {
        throw Error({"", fmt::format("you have a preset {} already", name), "",
                     "a name that is free, or leave to replace it (--replace)",
                     fmt::format("for example {}", freePresetName(name))});
    }
    savePreset(file, preset);
    return file;
}

std::string duplicatePreset(std::string_view nameOrFile, std::string_view newName) {
    const std::filesystem::path source = findPreset(nameOrFile);
    loadPreset(source);  // refuses to copy an invalid preset
    const std::string name =
        newName.empty() ? freePresetName(source.stem().string()) : std::string(newName);
    refuseTaken(name);
    std::ostringstream text;
    text << std::ifstream(source, std::ios::binary).rdbuf();
    replaceFile(userPresetFile(name), text.str());
    return name;
}

void renamePreset(std::string_view name, std::string_view newName) {
    const PresetEntry entry = ownEntry(name, "renamed");
    if (name == newName) return;
    const std::filesystem::path file = userPresetFile(newName);
    refuseTaken(newName);
    std::error_code fault;
    std::filesystem::rename(entry.file, file, fault);
    if (fault) throw Error({entry.file.string(), "cannot be renamed", fault.message(), "", ""});
}

void describePreset(std::string_view name, const PresetText& text) {
    const PresetEntry entry = ownEntry(name, "described again");
    LoadedPreset loaded = loadPreset(entry.file);
    if (!loaded.warnings.empty()) {
        throw Error({entry.file.string(), "holds keys that would be lost", loaded.warnings.front(),
                     "keys that this version knows", "edit the file itself"});
    }
    loaded.preset.title = text.title;
    loaded.preset.description = text.description;
    savePreset(entry.file, loaded.preset);
}

std::filesystem::path deletePreset(std::string_view name) {
    return moveToTrash(ownEntry(name, "deleted").file);
}

}  // namespace neph
