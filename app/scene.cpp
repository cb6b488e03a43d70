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

std::optional<int> parseIndex(std::string_view text, int count) {
    int index = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (fault != std::errc{} || end != text.data() + text.size()) return {};
    if (index < 0) index += count;
    if (index < 0 || index >= count) return {};
    return index;
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
    int index = 0;
    const std::string first = text.substr(0, text.find(':'));
    const auto [end, fault] = std::from_chars(first.data(), first.data() + first.size(), index);
    if (fault == std::errc{} && end == first.data() + first.size()) return index;
    throw UsageError({"--time", "cannot be read", text, "INDEX, a:b or all", ""});
}

std::vector<int> parseTimes(const std::string& text, const DatasetInfo& info) {
    const int count = static_cast<int>(info.times.size());
    if (text.empty()) return {defaultTime(info)};
    const std::size_t colon = text.find(':');
    const auto first = text == "all" ? 0 : parseIndex(text.substr(0, colon), count);
    const auto last = text == "all"                ? count - 1
                      : colon == std::string::npos ? first
                                                   : parseIndex(text.substr(colon + 1), count);
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
