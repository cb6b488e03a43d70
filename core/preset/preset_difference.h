// preset_difference.h: describes how two looks and cameras differ, and applies parts of a preset.
//
// Every parameter of the look table belongs to one part; the camera is a separate part.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/preset/preset.h"

namespace neph {

/// A set of parts, one bit each.
using PresetParts = unsigned;

/// A part of a preset that can be applied on its own.
struct PresetPart {
    PresetParts bit;
    std::string_view id;     ///< as written in `--parts`
    std::string_view label;  ///< on buttons
    std::string_view help;
};
inline constexpr std::array<PresetPart, 4> kPresetParts{{
    {1, "fields", "Fields", "what each field does to light, and the modes of that"},
    {2, "light", "Light", "how light goes through the cloud; sun, sky and ground"},
    {4, "view", "View", "engine, quality and exposure"},
    {8, "camera", "Camera", "where the picture is taken from"},
}};
inline constexpr PresetParts kPresetFields = 1, kPresetLight = 2, kPresetView = 4,
                             kPresetCamera = 8, kPresetAll = 15;

/// The part that a parameter belongs to: one bit.
PresetParts partOf(const Parameter& row);

/// Parses "all" or a list such as "fields,light". Throws Error naming the valid parts.
PresetParts parsePresetParts(std::string_view list);

/// "fields, light"; "all" for all of them.
std::string presetPartsText(PresetParts parts);

/// One parameter that differs, in the words of the screen.
struct PresetDifference {
    PresetParts part = kPresetFields;  ///< one bit
    std::string group, label;          ///< "Cloud", "Mixing scale"
    std::string before, after;         ///< as on screen, with units
};

/// The differences of `after` from `before`, in the order of the look table, the camera last;
/// cameras are compared only if both have one.
std::vector<PresetDifference> differences(const Look& before, const Look& after);
std::vector<PresetDifference> differences(const Preset& before, const Preset& after);

/// "Cloud: Mixing scale 1 -> 0.5".
std::string lineOf(const PresetDifference& difference);

/// One line each for the first `most`, then how many more; no newline at the end.
std::string linesOf(const std::vector<PresetDifference>& rows, std::size_t most);

/// Applies `parts` of a preset to look and camera.
void takeOver(const Preset& preset, PresetParts parts, Look& look, CameraPose& camera);

}  // namespace neph
