// preset_library.cpp: lists the bundled and the user's presets, and finds one by name.
#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/names.h"
#include "core/base/resources.h"
#include "core/preset/preset.h"

namespace neph {
namespace {

std::optional<std::filesystem::path> userPresetDir() {
    const auto dir = userDataDir();
    if (!dir) return {};
    return *dir / "presets";
}

std::vector<PresetEntry> presetsIn(const std::filesystem::path& dir, bool bundled) {
    std::vector<PresetEntry> entries;
    std::error_code error;
    for (const auto& item : std::filesystem::directory_iterator(dir, error)) {
        if (item.path().extension() != ".json" || !item.is_regular_file(error)) continue;
        entries.push_back({item.path().stem().string(), item.path(), bundled});
    }
    std::sort(entries.begin(), entries.end(),
              [](const PresetEntry& a, const PresetEntry& b) { return a.name < b.name; });
    return entries;
}

/// Suggests the nearest name.
[[noreturn]] void refuseUnknown(std::string_view name) {
    const std::vector<PresetEntry> entries = listPresets();
    std::vector<std::string_view> names;
    names.reserve(entries.size());
    for (const PresetEntry& entry : entries) names.push_back(entry.name);
    const std::string_view near = nearestName(name, names);
    throw Error(
        {"", fmt::format("there is no preset or file {}", name), "", "",
         near.empty() ? "nephoscope presets lists them" : fmt::format("did you mean {}?", near)});
}

}  // namespace

std::vector<PresetEntry> listPresets() {
    std::vector<PresetEntry> entries;
    if (const auto dir = findResource("presets")) entries = presetsIn(*dir, true);
    if (const auto dir = userPresetDir()) {
        for (PresetEntry& own : presetsIn(*dir, false)) {
            const auto same = std::find_if(entries.begin(), entries.end(),
                                           [&](const auto& e) { return e.name == own.name; });
            if (same != entries.end()) {
                *same = std::move(own);
            } else {
                entries.push_back(std::move(own));
            }
        }
    }
    return entries;
}

std::filesystem::file_time_type presetsStamp() {
    auto stamp = std::filesystem::file_time_type::min();
    for (const auto& dir : {findResource("presets"), userPresetDir()}) {
        std::error_code error;
        if (!dir) continue;
        const auto changed = std::filesystem::last_write_time(*dir, error);
        if (!error) stamp = std::max(stamp, changed);
    }
    return stamp;
}

std::filesystem::path findPreset(std::string_view nameOrFile) {
    for (PresetEntry& entry : listPresets()) {
        if (entry.name == nameOrFile) return std::move(entry.file);
    }
    std::error_code error;
    if (std::filesystem::exists(nameOrFile, error)) return nameOrFile;
    refuseUnknown(nameOrFile);
}

std::string presetNameFault(std::string_view name) {
    if (name.empty()) return "a name is missing";
    if (name.size() > 100) return "a name has at most 100 letters";
    if (name.front() == '.') return "a name does not begin with '.'";
    if (name.front() == ' ' || name.back() == ' ')
        return "a name does not begin or end with a space";
    for (const char c : name) {
        if (c == '/') return "a name holds no '/'";
        if (static_cast<unsigned char>(c) < 32) return "a name is one line";
    }
    return {};
}

std::filesystem::path userPresetFile(std::string_view name) {
    if (const std::string fault = presetNameFault(name); !fault.empty()) {
        throw Error({"", "this cannot be the name of a preset", fmt::format("'{}'", name),
                     "1 to 100 letters without '/', not opening with '.'", fault});
    }
    const auto dir = userPresetDir();
    if (!dir) throw Error({"", "there is no place for presets", "", "HOME or XDG_DATA_HOME", ""});
    std::error_code error;
    std::filesystem::create_directories(*dir, error);
    if (error) throw Error({dir->string(), "cannot be made", error.message(), "", ""});
    return *dir / (std::string(name) + ".json");
}

}  // namespace neph
