// preset_difference.cpp: parses the names of parts, and compares looks row by row.
#include "core/preset/preset_difference.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/names.h"

namespace neph {
namespace {

/// The numbers of a camera on screen, except the target.
struct CameraNumber {
    std::string_view label, unit;
    float CameraPose::*member;
};
constexpr std::array<CameraNumber, 4> kCameraNumbers{{{"Distance", "", &CameraPose::distance},
                                                      {"Azimuth", "°", &CameraPose::azimuthDeg},
                                                      {"Elevation", "°", &CameraPose::elevationDeg},
                                                      {"Field of view", "°", &CameraPose::fovDeg}}};

/// As on screen, or with all digits where the two would look the same on screen.
PresetDifference differenceOf(const Parameter& row, const ParameterValue& before,
                              const ParameterValue& after) {
    PresetDifference difference{partOf(row), row.group, row.label, screenText(row, before),
                                screenText(row, after)};
    if (difference.before == difference.after) {
        const bool plain = row.unit.empty() || row.unit == "1";
        const std::string unit = plain ? "" : " " + row.unit;
        difference.before = formatValue(row, before) + unit;
        difference.after = formatValue(row, after) + unit;
    }
    return difference;
}

void addCamera(std::string_view label, std::string_view unit, float before, float after,
               std::vector<PresetDifference>& rows) {
    if (before == after) return;
    const auto text = [&](float value) { return fmt::format("{:.4g}{}", value, unit); };
    const bool apart = text(before) != text(after);
    const auto exact = [&](float value) { return fmt::format("{}{}", value, unit); };
    rows.push_back({kPresetCamera, "Camera", std::string(label),
                    apart ? text(before) : exact(before), apart ? text(after) : exact(after)});
}

void addCameras(const CameraPose& before, const CameraPose& after,
                std::vector<PresetDifference>& rows) {
    constexpr std::array<std::string_view, 3> kTargets{"Target east", "Target north",
                                                       "Target height"};
    for (int axis = 0; axis < 3; ++axis) {
        addCamera(kTargets[static_cast<std::size_t>(axis)], "", before.target[axis],
                  after.target[axis], rows);
    }
    for (const CameraNumber& number : kCameraNumbers) {
        addCamera(number.label, number.unit, before.*(number.member), after.*(number.member), rows);
    }
}

}  // namespace

PresetParts partOf(const Parameter& row) {
    return bitOf(row.part);
}

PresetParts parsePresetParts(std::string_view list) {
    if (list == "all") return kPresetAll;
    std::vector<std::string_view> known{"all"};
    for (const PresetPart& part : kPresetParts) known.push_back(part.id);
    PresetParts parts = 0;
    for (std::string_view rest = list;;) {
        const std::size_t comma = rest.find(',');
        const std::string_view name = rest.substr(0, comma);
        const auto part = std::ranges::find(kPresetParts, name, &PresetPart::id);
        if (part == kPresetParts.end()) {
            const std::string_view near = nearestName(name, known);
            throw Error({"", fmt::format("a preset has no part '{}'", name), "",
                         "all, or a list of fields, light, view and camera",
                         near.empty() ? "" : fmt::format("did you mean {}?", near)});
        }
        parts |= part->bit;
        if (comma == std::string_view::npos) return parts;
        rest.remove_prefix(comma + 1);
    }
}

std::string presetPartsText(PresetParts parts) {
    if (parts == kPresetAll) return "all";
    std::string text;
    for (const PresetPart& part : kPresetParts) {
        if ((parts & part.bit) == 0) continue;
        text += (text.empty() ? "" : ", ") + std::string(part.id);
    }
    return text;
}

std::vector<PresetDifference> differences(const Look& before, const Look& after) {
    std::vector<PresetDifference> rows;
    for (const Parameter& row : lookTable()) {
        const ParameterValue was = valueOf(before, row), is = valueOf(after, row);
        if (was != is) rows.push_back(differenceOf(row, was, is));
    }
    return rows;
}

std::vector<PresetDifference> differences(const Preset& before, const Preset& after) {
    std::vector<PresetDifference> rows = differences(before.look, after.look);
    if (before.camera && after.camera) addCameras(*before.camera, *after.camera, rows);
    return rows;
}

std::string lineOf(const PresetDifference& difference) {
    return fmt::format("{}: {} {} -> {}", difference.group, difference.label, difference.before,
                       difference.after);
}

std::string linesOf(const std::vector<PresetDifference>& rows, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < std::min(most, rows.size()); ++i) {
        text += (i == 0 ? "" : "\n") + lineOf(rows[i]);
    }
    if (rows.size() > most) text += fmt::format("\nand {} more", rows.size() - most);
    return text;
}

void takeOver(const Preset& preset, PresetParts parts, Look& look, CameraPose& camera) {
    for (const Parameter& row : lookTable()) {
        if ((partOf(row) & parts) != 0) setValue(look, row, valueOf(preset.look, row));
    }
    if ((parts & kPresetCamera) != 0 && preset.camera) camera = *preset.camera;
}

}  // namespace neph
