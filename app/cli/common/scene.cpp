// scene.cpp: presets, assignments, cameras and times from their spelling on the command line.
#include "app/cli/common/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "core/dataset/ensemble.h"
#include "core/dataset/file_list.h"
#include "core/preset/preset_difference.h"
#include "core/preset/preset_files.h"
#include "core/session/session.h"
#include "core/session/settings.h"
#include "core/volume/memory_setting.h"

namespace neph {
namespace {

constexpr double kMPerKm = 1000.0;
// Of the GPU memory that is free; images, tables and other programs need some too. Tuned by eye.
constexpr double kDeviceShare = 0.75;

std::optional<int> parseInteger(std::string_view text) {
    int number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc{} || end != text.data() + text.size()) return {};
    return number;
}

/// "march, slicing"
std::string engineNames(unsigned engines) {
    std::vector<std::string_view> names;
    for (const EngineTraits& engine : kEngines) {
        if ((engines & bitOf(engine.engine)) != 0) names.push_back(engine.id);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

/// "a:b" as two numbers, the first less than the second.
std::optional<glm::dvec2> parsePair(std::string_view text) {
    glm::dvec2 pair{0.0};
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, pair.x);
    if (first.ec != std::errc{} || first.ptr == end || *first.ptr != ':') return {};
    const auto second = std::from_chars(first.ptr + 1, end, pair.y);
    const bool whole = second.ec == std::errc{} && second.ptr == end;
    if (!whole || !std::isfinite(pair.x) || !std::isfinite(pair.y) || pair.x >= pair.y) return {};
    return pair;
}

/// Takes over `parts` of a preset.
void applyPreset(const std::string& nameOrFile, PresetParts parts, Scene& scene) {
    const std::filesystem::path file = findPreset(nameOrFile);
    const LoadedPreset loaded = loadPreset(file);
    scene.presetName = presetNameOf(file.string());
    takeOver(loaded.preset, parts, scene.document.look, scene.document.camera);
    if ((parts & kPresetFields) != 0) scene.inMetres = loaded.inMetres;
    scene.cameraAsked |= (parts & kPresetCamera) != 0 && loaded.preset.camera.has_value();
    for (const auto& texts : {loaded.warnings, loaded.notes}) {
        scene.warnings.insert(scene.warnings.end(), texts.begin(), texts.end());
    }
}

/// The preset of the request, upon the standard one where it is not taken as a whole.
void applyPresets(const SceneRequest& request, bool started, Scene& scene) {
    const bool whole = !request.preset.empty() && request.parts == kPresetAll;
    if (!started && !whole && presetNameUse("default") != PresetNameUse::free) {
        applyPreset("default", kPresetAll, scene);
        scene.cameraAsked = false;  // nobody named that preset
    }
    if (!request.preset.empty()) applyPreset(request.preset, request.parts, scene);
}

}  // namespace

Scene makeScene(const SceneRequest& request, const std::optional<Scene>& start) {
    Scene scene = start.value_or(Scene{});
    applyPresets(request, start.has_value(), scene);
    for (const auto* settings : {&request.settings, &request.engineSettings}) {
        for (const Setting& setting : *settings) {
            setValue(scene.document, *setting.row, setting.value);
            scene.inMetres &= ~noiseScaleField(*setting.row);
        }
    }
    if (!request.camera.empty()) {
        scene.document.camera = loadCamera(request.camera, scene.warnings);
        scene.cameraAsked = true;
    }
    return scene;
}

void checkActing(const std::string& option, unsigned with, unsigned engines) {
    if ((with & engines) != 0) return;
    throw UsageError({.where = option,
                      .what = "does not act with the engine in use",
                      .found = engineNames(engines),
                      .expected = engineNames(with),
                      .hint = "leave it out, or choose another engine with --engine"});
}

Setting parseSetting(const std::string& option, std::string_view assignment) {
    return asUsage(fmt::format("{} {}", option, assignment), [&]() -> Setting {
        ParameterSet values;
        applyAssignment(values, assignment);
        const Parameter& row = parameter(assignment.substr(0, assignment.find('=')));
        return {option, &row, valueOf(values, row)};
    });
}

Setting parseAlias(const std::string& option, const std::string& text) {
    const Parameter& row = parameterOfOption(option);
    return asUsage(option, [&]() -> Setting {
        ParameterSet values;
        setValue(values, row, parseScreenValue(row, text));
        return {option, &row, valueOf(values, row)};
    });
}

void checkSetOnce(const std::vector<Setting>& settings) {
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const Setting& setting = settings[i];
        const auto end = settings.begin() + static_cast<std::ptrdiff_t>(i);
        const auto other = std::find_if(
            settings.begin(), end, [&](const Setting& each) { return each.row == setting.row; });
        if (other == end) continue;
        throw UsageError({.where = setting.option,
                          .what = setting.row->id + " is set twice",
                          .found = fmt::format("{} and {}", formatValue(*other->row, other->value),
                                               formatValue(*setting.row, setting.value)),
                          .hint = "give it once"});
    }
}

TimeRange parseTimeRange(const std::string& option, const std::string& text) {
    const std::string typed = option + " " + text;
    if (text == "all") return {0, -1, typed};
    const std::string_view view = text;
    const std::size_t colon = view.find(':');
    const auto first = parseInteger(view.substr(0, colon));
    const auto last = colon == view.npos ? first : parseInteger(view.substr(colon + 1));
    if (first && last) return {*first, *last, typed};
    throw UsageError({option, "cannot be read", text, "INDEX, a:b or all", ""});
}

BoxM parseRegion(const std::string& text) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    BoxM region{{0.0, 0.0, -kFar}, {0.0, 0.0, kFar}};
    std::string_view rest = text;
    int axis = 0;
    for (; axis < 3 && !rest.empty(); ++axis) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const auto pair = parsePair(rest.substr(0, comma));
        if (!pair) break;
        region.lowerM[axis] = pair->x * kMPerKm;
        region.upperM[axis] = pair->y * kMPerKm;
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    if (axis >= 2 && rest.empty() && text.back() != ',') return region;
    throw UsageError({"--region", "cannot be read", text,
                      "x0:x1,y0:y1 or x0:x1,y0:y1,z0:z1 in km, lower before upper",
                      "nephoscope info FILE... tells the domain"});
}

std::uint64_t rendererBytes(const gl::DeviceMemory& device) {
    if (device.software) return kSoftwareGpuBytes;
    // A GPU that does not say shares the memory of the machine, as those of processors do.
    if (device.freeBytes == 0) return memoryBudget("", 0).machine;
    return static_cast<std::uint64_t>(kDeviceShare * static_cast<double>(device.freeBytes));
}

MemoryBudget chooseBudget(const std::string& memory, std::uint64_t gpuBytes,
                          std::vector<std::string>& warnings) {
    if (!memory.empty()) {
        return asUsage("--memory", [&] { return memoryBudget(memory, gpuBytes); });
    }
    try {
        return memoryBudget(loadSettings(warnings).memory, gpuBytes);
    } catch (const Error& error) {
        warnings.push_back(error.message());
        return memoryBudget("", gpuBytes);
    }
}

std::shared_ptr<Dataset> openData(const std::vector<std::string>& files,
                                  const std::vector<std::string>& members, const PluginHost& host,
                                  const Progress& progress) {
    const OpenRun openRun = [&host](std::span<const std::filesystem::path> paths,
                                    const Progress& part) {
        return Dataset::open(paths, host, part);
    };
    if (members.empty()) return openRun(listFiles(files), progress);
    return Ensemble::open(listMembers(members), openRun, progress);
}

int memberOf(const Dataset& dataset, const std::string& asked, int otherwise) {
    const Ensemble* ensemble = ensembleOf(dataset);
    if (asked.empty()) {
        return ensemble == nullptr ? 0 : std::clamp(otherwise, kMeanMember, ensemble->count() - 1);
    }
    const std::string typed = "--member " + asked;
    if (ensemble == nullptr) {
        throw UsageError({.where = typed,
                          .what = "the data are a single run",
                          .hint = "--members RUN RUN... opens several as an ensemble"});
    }
    return asUsage(typed, [&] { return ensemble->memberNamed(asked); });
}

std::vector<int> timesOf(const std::optional<TimeRange>& range, const DatasetInfo& info) {
    if (!range) return {defaultTime(info)};
    const int count = static_cast<int>(info.times.size());
    const int first = range->first + (range->first < 0 ? count : 0);
    const int last = range->last + (range->last < 0 ? count : 0);
    if (first < 0 || last >= count || first > last) {
        throw UsageError({range->typed, "there are no such times", "",
                          fmt::format("INDEX, a:b or all, with indices from 0 to {}", count - 1),
                          "nephoscope info FILE... lists the times"});
    }
    std::vector<int> times;
    for (int i = first; i <= last; ++i) times.push_back(i);
    return times;
}

}  // namespace neph
