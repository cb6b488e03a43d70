// presets_command.cpp: listing, showing and checking presets, and the parameter reference.
#include "app/cli/presets_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "core/error.h"
#include "core/preset.h"

namespace neph {
namespace {

std::string titleOf(const PresetEntry& entry) {
    try {
        return loadPreset(entry.file).preset.title;
    } catch (const Error& error) {
        return "(unreadable: " + error.parts().what + ")";
    }
}

std::string shown(const Parameter& row) {
    return formatValue(row, defaultOf(row));
}

std::string cell(const Parameter& row) {
    const bool plain = row.kind == ParameterKind::toggle || row.kind == ParameterKind::choice ||
                       row.unit == "1" || row.unit.empty();
    return fmt::format("| `{}` | {} | {}{}{} | {} |\n", row.id, rangeText(row), shown(row),
                       plain ? "" : " ", plain ? "" : row.unit, row.help);
}

}  // namespace

int runPresetsList() {
    std::size_t width = 0;
    const std::vector<PresetEntry> entries = listPresets();
    for (const PresetEntry& entry : entries) width = std::max(width, entry.name.size());
    for (const PresetEntry& entry : entries) {
        fmt::print("{:<{}}  {}{}\n", entry.name, width, entry.bundled ? "" : "(yours) ",
                   titleOf(entry));
    }
    return 0;
}

int runPresetsShow(const std::string& nameOrFile) {
    const LoadedPreset loaded = loadPreset(findPreset(nameOrFile));
    for (const std::string& warning : loaded.warnings) fmt::print(stderr, "warning: {}\n", warning);
    fmt::print("{}", formatPreset(loaded.preset));
    return 0;
}

int runPresetsCheck(const std::vector<std::string>& files) {
    int status = 0;
    for (const std::string& file : files) {
        try {
            const LoadedPreset loaded = loadPreset(findPreset(file));
            for (const std::string& warning : loaded.warnings) {
                fmt::print(stderr, "warning: {}\n", warning);
            }
            if (!loaded.warnings.empty()) status = 1;
            fmt::print("{}: {}\n", file, loaded.warnings.empty() ? "right" : "has unknown keys");
        } catch (const Error& error) {
            fmt::print(stderr, "error: {}\n", error.message());
            status = 1;
        }
    }
    return status;
}

std::string parameterReference() {
    std::string page =
        "# Parameters\n\n"
        "Every tunable of the picture, as it is spelled in presets and in `--set id=value`. SI "
        "units; colours are linear\nred, green and blue. This page is printed by `nephoscope "
        "presets parameters`; change the look table, not the page.\n";
    std::string group;
    for (const Parameter& row : lookTable()) {
        if (row.group != group) {
            group = row.group;
            page += fmt::format(
                "\n## {}\n\n| id | takes | default | meaning |\n|---|---|---|---|\n", group);
        }
        page += cell(row);
    }
    return page;
}

int runPresetsParameters() {
    fmt::print("{}", parameterReference());
    return 0;
}

}  // namespace neph
