// preset_difference.h: in what two looks and cameras differ, in words, and taking over parts of a
// preset.
//
// Every parameter of the look table belongs to one part; the camera is a part of its own.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/preset/preset.h"

namespace neph {

/// A set of parts, a bit each.
using PresetParts = unsigned;

struct PresetPart {
    PresetParts bit;
    std::string_view id;     ///< as `--parts` spells it
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

/// Parts named by "all" or "fields,light". Throws Error naming those there are.
PresetParts parsePresetParts(std::string_view list);

/// "fields, light"; "all" for all of them.
std::string presetPartsText(PresetParts parts);

struct PresetDifference {
    PresetParts part = kPresetFields;  ///< one bit
    std::string group, label;          ///< "Cloud", "Mixing scale"
    std::string before, after;         ///< as on screen, with units
};

/// What `after` has otherwise than `before`, in the order of the look table, the camera last; where
/// one of the two has no camera, cameras do not differ.
std::vector<PresetDifference> differences(const Look& before, const Look& after);
std::vector<PresetDifference> differences(const Preset& before, const Preset& after);

/// "Cloud: Mixing scale 1 -> 0.5".
std::string lineOf(const PresetDifference& difference);

/// One line each for the first `most`, then how many more; no newline at the end.
std::string linesOf(const std::vector<PresetDifference>& rows, std::size_t most);

/// Puts `parts` of a preset into look and camera.
void takeOver(const Preset& preset, PresetParts parts, Look& look, CameraPose& camera);

}  // namespace neph
