// presets_command.cpp: presets listed, compared and kept, and the parameter reference.
#include "app/cli/presets_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "core/base/error.h"
#include "core/preset/preset_difference.h"
#include "core/preset/preset_files.h"

namespace neph {
namespace {

std::string titleOf(const PresetEntry& entry) {
    try {
        return loadPreset(entry.file).preset.title;
    } catch (const Error& error) {
        return "(unreadable: " + error.parts().what + ")";
    }
}

constexpr std::string_view kAboutSampling =
    "How finely an image is computed. Sessions keep these, presets do not.\n\n";

std::string shown(const Parameter& row) {
    return formatValue(row, defaultOf(row));
}

std::string cell(const Parameter& row) {
    const bool plain = row.kind == ParameterKind::toggle || row.kind == ParameterKind::choice ||
                       row.unit == "1" || row.unit.empty();
    return fmt::format("| `{}` | {} | {}{}{} | {} |\n", row.id, rangeText(row), shown(row),
                       plain ? "" : " ", plain ? "" : row.unit, row.help);
}

void printRemarks(const LoadedPreset& loaded) {
    for (const std::string& warning : loaded.warnings) fmt::print(stderr, "warning: {}\n", warning);
    for (const std::string& note : loaded.notes) fmt::print(stderr, "note: {}\n", note);
}

int runList() {
    std::size_t width = 0;
    const std::vector<PresetEntry> entries = listPresets();
    for (const PresetEntry& entry : entries) width = std::max(width, entry.name.size());
    for (const PresetEntry& entry : entries) {
        fmt::print("{:<{}}  {}  {}\n", entry.name, width, entry.bundled ? "bundled" : "yours  ",
                   titleOf(entry));
    }
    return 0;
}

int runShow(const std::string& nameOrFile) {
    const LoadedPreset loaded = loadPreset(findPreset(nameOrFile));
    printRemarks(loaded);
    fmt::print("{}", formatPreset(loaded.preset));
    return 0;
}

int runCheck(const std::vector<std::string>& files) {
    int status = 0;
    for (const std::string& file : files) {
        try {
            const LoadedPreset loaded = loadPreset(findPreset(file));
            printRemarks(loaded);
            if (!loaded.warnings.empty()) status = 1;
            fmt::print("{}: {}\n", file, loaded.warnings.empty() ? "right" : "has unknown keys");
        } catch (const Error& error) {
            fmt::print(stderr, "error: {}\n", error.message());
            status = 1;
        }
    }
    return status;
}

int runDiff(const std::string& before, const std::string& after) {
    const auto rows =
        differences(loadPreset(findPreset(before)).preset, loadPreset(findPreset(after)).preset);
    for (const PresetDifference& row : rows) fmt::print("{}\n", lineOf(row));
    if (rows.empty()) fmt::print("no difference in look and camera\n");
    return 0;
}

int runSave(const PresetsOptions& options) {
    const Scene scene = makeScene(options.scene);
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "warning: {}\n", warning);
    const auto file = saveOwnPreset(options.preset,
                                    {options.title.value_or(""), options.description.value_or(""),
                                     scene.document.look, scene.document.camera},
                                    options.replace);
    fmt::print("saved {}\n", file.string());
    if (scene.document.sampling != Sampling{}) {
        fmt::print(stderr, "note: without {}, which a preset does not hold\n",
                   formatAssignments(samplingTable(), scene.document));
    }
    return 0;
}

int runDelete(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        fmt::print("{} is now {}\n", name, deletePreset(name).string());
    }
    return 0;
}

int runDescribe(const PresetsOptions& options) {
    const Preset before = loadPreset(presetEntry(options.preset).file).preset;
    describePreset(options.preset, {options.title.value_or(before.title),
                                    options.description.value_or(before.description)});
    return 0;
}

}  // namespace

int runPresets(std::string_view subcommand, const PresetsOptions& options) {
    if (subcommand == "show") return runShow(options.preset);
    if (subcommand == "check") return runCheck(options.several);
    if (subcommand == "diff") return runDiff(options.preset, options.other);
    if (subcommand == "save") return runSave(options);
    if (subcommand == "describe") return runDescribe(options);
    if (subcommand == "delete") return runDelete(options.several);
    if (subcommand == "duplicate") {
        fmt::print("{}\n", duplicatePreset(options.preset, options.other));
    } else if (subcommand == "rename") {
        renamePreset(options.preset, options.other);
    } else if (subcommand == "parameters") {
        fmt::print("{}", parameterReference());
    } else {
        return runList();
    }
    return 0;
}

std::string parameterReference() {
    std::string page =
        "# Parameters\n\n"
        "Every tunable of the image, as it is spelled in presets and in `--set id=value`. SI "
        "units; colours are linear\nred, green and blue. This page is printed by `nephoscope "
        "presets parameters`; change the look table, not the page.\n";
    std::string group;
    for (const Parameter& row : parameterTable()) {
        if (row.group != group) {
            group = row.group;
            page +=
                fmt::format("\n## {}\n\n{}| id | takes | default | meaning |\n|---|---|---|---|\n",
                            group, row.part == ParameterPart::sampling ? kAboutSampling : "");
        }
        page += cell(row);
    }
    return page;
}

}  // namespace neph
