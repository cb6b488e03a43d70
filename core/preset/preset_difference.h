// preset_difference.h: describes how two looks and cameras differ, and applies parts of a preset.
//
// Every row of the look table says which part it belongs to; the camera is a separate part.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/look/parameter.h"
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
constexpr PresetParts bitOf(ParameterPart part) {
    return 1u << static_cast<unsigned>(part);
}
/// The camera has the bit after those of parameters.
inline constexpr PresetParts kPresetFields = bitOf(ParameterPart::fields),
                             kPresetLight = bitOf(ParameterPart::light),
                             kPresetView = bitOf(ParameterPart::view),
                             kPresetCamera = bitOf(ParameterPart::sampling) << 1u,
                             kPresetAll =
                                 kPresetFields | kPresetLight | kPresetView | kPresetCamera;
inline constexpr std::array<PresetPart, 4> kPresetParts{{
    {kPresetFields, "fields", "Fields", "what each field does to light, and the modes of that"},
    {kPresetLight, "light", "Light", "how light goes through the cloud; sun, sky and ground"},
    {kPresetView, "view", "View", "engine, planes and exposure"},
    {kPresetCamera, "camera", "Camera", "where the image is taken from"},
}};

/// The part that a row of the look table belongs to: one bit.
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
