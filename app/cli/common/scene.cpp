// scene.cpp: presets, assignments, cameras and times from their spelling on the command line.
#include "app/cli/common/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "core/preset/preset_difference.h"
#include "core/preset/preset_files.h"
#include "core/session/session.h"
#include "core/session/settings.h"
#include "core/volume/memory_setting.h"

namespace neph {
namespace {

constexpr double kMPerKm = 1000.0;
// Of the GPU memory that is free; pictures, tables and other programs need some too. Tuned by eye.
constexpr double kDeviceShare = 0.75;

std::optional<int> parseNumber(std::string_view text) {
    int number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc{} || end != text.data() + text.size()) return {};
    return number;
}

/// Index of one of `count` times; negative counts from the end.
std::optional<int> parseIndex(std::string_view text, int count) {
    std::optional<int> index = parseNumber(text);
    if (index && *index < 0) *index += count;
    return index && *index >= 0 && *index < count ? index : std::nullopt;
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
    for (const auto& texts : {loaded.warnings, loaded.notes}) {
        scene.warnings.insert(scene.warnings.end(), texts.begin(), texts.end());
    }
}

PresetParts partsOf(const SceneOptions& options) {
    if (options.parts.empty()) return kPresetAll;
    if (options.preset.empty()) {
        throw UsageError({"--parts", "is of a preset", "", "--preset NAME", ""});
    }
    try {
        return parsePresetParts(options.parts);
    } catch (const Error& error) {
        ErrorParts parts = error.parts();
        parts.where = "--parts " + options.parts;
        throw UsageError(parts);
    }
}

/// The preset of the options, upon the standard one where it is not taken as a whole.
void applyPresets(const SceneOptions& options, bool started, Scene& scene) {
    const PresetParts parts = partsOf(options);
    const bool whole = !options.preset.empty() && parts == kPresetAll;
    if (!started && !whole && presetNameUse("default") != PresetNameUse::free) {
        applyPreset("default", kPresetAll, scene);
    }
    if (!options.preset.empty()) applyPreset(options.preset, parts, scene);
}

}  // namespace

Scene makeScene(const SceneOptions& options, const std::optional<Scene>& start) {
    Scene scene = start.value_or(Scene{});
    applyPresets(options, start.has_value(), scene);
    for (const std::string& assignment : options.assignments) {
        try {
            applyAssignment(scene.document, assignment);
        } catch (const Error& error) {
            ErrorParts parts = error.parts();
            parts.where = "--set " + assignment;
            throw UsageError(parts);
        }
    }
    if (!options.camera.empty()) {
        scene.document.camera = loadCamera(options.camera, scene.warnings);
    }
    return scene;
}

std::optional<int> parseFirstTime(const std::string& text) {
    if (text.empty()) return {};
    if (text == "all") return 0;
    if (const auto first = parseNumber(std::string_view(text).substr(0, text.find(':')))) {
        return first;
    }
    throw UsageError({"--time", "cannot be read", text, "INDEX, a:b or all", ""});
}

std::optional<Region> parseRegion(const std::string& text) {
    if (text.empty()) return {};
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Region region{{0.0, 0.0, -kFar}, {0.0, 0.0, kFar}};
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
        try {
            return memoryBudget(memory, gpuBytes);
        } catch (const Error& error) {
            ErrorParts parts = error.parts();
            parts.where = "--memory";
            throw UsageError(parts);
        }
    }
    try {
        return memoryBudget(loadSettings(warnings).memory, gpuBytes);
    } catch (const Error& error) {
        warnings.push_back(error.message());
        return memoryBudget("", gpuBytes);
    }
}

std::vector<int> parseTimes(const std::string& text, const DatasetInfo& info) {
    const int count = static_cast<int>(info.times.size());
    if (text.empty()) return {defaultTime(info)};
    const std::string_view range = text == "all" ? "0:-1" : std::string_view(text);
    const std::size_t colon = range.find(':');
    const auto first = parseIndex(range.substr(0, colon), count);
    const auto last = colon == range.npos ? first : parseIndex(range.substr(colon + 1), count);
    if (!first || !last || *first > *last) {
        throw UsageError({"--time " + text, "there are no such times", "",
                          fmt::format("INDEX, a:b or all, with indices from 0 to {}", count - 1),
                          "nephoscope info FILE... lists the times"});
    }
    std::vector<int> times;
    for (int i = *first; i <= *last; ++i) times.push_back(i);
    return times;
}

}  // namespace neph
