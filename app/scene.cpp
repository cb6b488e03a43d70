// scene.cpp: presets, assignments, cameras and times from their spelling on the command line.
#include "app/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/preset.h"
#include "core/session.h"

namespace neph {
namespace {

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

void applyPreset(const SceneOptions& options, Scene& scene) {
    const std::vector<PresetEntry> known = listPresets();
    const bool hasDefault = std::any_of(known.begin(), known.end(),
                                        [](const auto& entry) { return entry.name == "default"; });
    if (options.preset.empty() && !hasDefault) return;
    const std::filesystem::path file =
        findPreset(options.preset.empty() ? "default" : options.preset);
    LoadedPreset loaded = loadPreset(file);
    scene.presetName = file.stem().string();
    scene.document.look = loaded.preset.look;
    if (loaded.preset.camera) scene.document.camera = *loaded.preset.camera;
    scene.warnings = std::move(loaded.warnings);
}

}  // namespace

Scene makeScene(const SceneOptions& options) {
    Scene scene;
    applyPreset(options, scene);
    for (const std::string& assignment : options.assignments) {
        try {
            applyAssignment(scene.document.look, assignment);
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
