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

int runSave(const PresetsRequest& request) {
    const Scene scene = makeScene(request.scene);
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "warning: {}\n", warning);
    const auto file = saveOwnPreset(request.preset,
                                    {request.title.value_or(""), request.description.value_or(""),
                                     scene.document.look, scene.document.camera},
                                    request.replace);
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

int runDescribe(const PresetsRequest& request) {
    const Preset before = loadPreset(presetEntry(request.preset).file).preset;
    describePreset(request.preset, {request.title.value_or(before.title),
                                    request.description.value_or(before.description)});
    return 0;
}

}  // namespace

int runPresets(const PresetsRequest& request) {
    switch (request.action) {
        case PresetsAction::list:
            return runList();
        case PresetsAction::show:
            return runShow(request.preset);
        case PresetsAction::check:
            return runCheck(request.several);
        case PresetsAction::diff:
            return runDiff(request.preset, request.other);
        case PresetsAction::parameters:
            fmt::print("{}", parameterReference());
            return 0;
        case PresetsAction::save:
            return runSave(request);
        case PresetsAction::duplicate:
            fmt::print("{}\n", duplicatePreset(request.preset, request.other));
            return 0;
        case PresetsAction::rename:
            renamePreset(request.preset, request.other);
            return 0;
        case PresetsAction::describe:
            return runDescribe(request);
        case PresetsAction::remove:
            return runDelete(request.several);
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
