// preset_read.cpp: presets out of JSON from strangers; every fault becomes an Error.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/preset.h"
#include "core/preset_format.h"
#include "core/strict_json.h"

namespace neph {
namespace {

/// Keeps the order of keys. Numbers are kept as float, so that a float written in its shortest form
/// reads back bit for bit.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                  std::int64_t, std::uint64_t, float>;

constexpr std::size_t kMaxJsonBytes = std::size_t{1} << 20;  // a preset has 8 KiB
constexpr std::array<std::string_view, 6> kTopKeys{"type",        "version", "title",
                                                   "description", "look",    "camera"};

std::string readPresetText(const std::filesystem::path& file) {
    return readJsonText(file, "a preset", kMaxJsonBytes);
}

std::optional<glm::vec3> toVector(const Json& value) {
    if (!value.is_array() || value.size() != 3) return {};
    glm::vec3 v{0.0f};
    for (int i = 0; i < 3; ++i) {
        const Json& item = value[static_cast<std::size_t>(i)];
        if (!item.is_number()) return {};
        v[i] = item.get<float>();
    }
    return v;
}

std::optional<int> toChoice(const Parameter& row, const Json& value) {
    if (!value.is_string()) return {};
    const auto& name = value.get_ref<const std::string&>();
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        if (row.choices[i] == name) return static_cast<int>(i);
    }
    return {};
}

std::optional<int> toInteger(const Json& value) {
    if (!value.is_number()) return {};
    const auto number = value.get<double>();
    if (std::abs(number) > 1e9 || number != std::floor(number)) return {};
    return static_cast<int>(number);
}

std::optional<ParameterValue> toValue(const Parameter& row, const Json& value) {
    switch (row.kind) {
        case ParameterKind::toggle:
            if (value.is_boolean()) return value.get<bool>();
            return {};
        case ParameterKind::integer:
            return toInteger(value);
        case ParameterKind::choice:
            return toChoice(row, value);
        case ParameterKind::colour:
            return toVector(value);
        case ParameterKind::number:
            break;
    }
    if (!value.is_number()) return {};
    return value.get<float>();
}

void readLook(const Json& values, Look& look, std::string_view where,
              std::vector<std::string>& warnings) {
    std::vector<std::string_view> known;
    for (const Parameter& row : lookTable()) known.push_back(row.id);
    for (const auto& [key, value] : values.items()) {
        const Parameter* row = findParameter(key);
        if (row == nullptr) {
            warnings.push_back(unknownJsonKey(where, key, known));
            continue;
        }
        const auto read = toValue(*row, value);
        if (!read) {
            throw Error({std::string(where),
                         fmt::format("parameter {} cannot take this value", key), excerpt(value),
                         rangeText(*row), ""});
        }
        setValue(look, *row, *read, where);
    }
}

float cameraNumber(const Json& value, std::string_view key, float lo, float hi,
                   std::string_view where) {
    if (value.is_number()) {
        const auto number = value.get<float>();
        if (number >= lo && number <= hi) return number;
    }
    throw Error({std::string(where), fmt::format("camera \"{}\" cannot take this value", key),
                 excerpt(value), fmt::format("a number from {} to {}", lo, hi), ""});
}

glm::vec3 cameraTarget(const Json& value, std::string_view where) {
    const auto target = toVector(value);
    bool fits = target.has_value();
    for (int i = 0; fits && i < 3; ++i) {
        fits = (*target)[i] >= kMinTarget && (*target)[i] <= kMaxTarget;
    }
    if (fits) return *target;
    throw Error({std::string(where), "camera \"target\" cannot take this value", excerpt(value),
                 fmt::format("three numbers from {} to {}", kMinTarget, kMaxTarget), ""});
}

CameraPose readCamera(const Json& values, std::string_view where,
                      std::vector<std::string>& warnings) {
    CameraPose pose;
    std::vector<std::string_view> known{"target"};
    for (const CameraKey& row : kCameraKeys) known.push_back(row.key);
    for (const auto& [key, value] : values.items()) {
        const auto row = std::ranges::find(kCameraKeys, key, &CameraKey::key);
        if (key == "target") {
            pose.target = cameraTarget(value, where);
        } else if (row != kCameraKeys.end()) {
            pose.*(row->member) = cameraNumber(value, key, row->lo, row->hi, where);
        } else {
            warnings.push_back(unknownJsonKey(where, key, known));
        }
    }
    return pose;
}

}  // namespace

LoadedPreset parsePreset(std::string_view content, std::string_view where) {
    const Json document = parseStrictJson<Json>(content, where);
    checkJsonHeader(document, where, "a Nephoscope preset", kPresetType, kPresetVersion);
    LoadedPreset loaded;
    loaded.preset.title = jsonText(document, "title", where);
    loaded.preset.description = jsonText(document, "description", where);
    for (const auto& [key, value] : document.items()) {
        if (key == "look") {
            readLook(jsonObject(value, key, where), loaded.preset.look, where, loaded.warnings);
        } else if (key == "camera") {
            loaded.preset.camera =
                readCamera(jsonObject(value, key, where), where, loaded.warnings);
        } else if (std::find(kTopKeys.begin(), kTopKeys.end(), key) == kTopKeys.end()) {
            loaded.warnings.push_back(unknownJsonKey(where, key, kTopKeys));
        }
    }
    return loaded;
}

LoadedPreset loadPreset(const std::filesystem::path& file) {
    return parsePreset(readPresetText(file), file.string());
}

CameraPose loadCamera(std::string_view nameOrFile, std::vector<std::string>& warnings) {
    const std::filesystem::path file = findPreset(nameOrFile);
    const std::string where = file.string();
    const Json document = parseStrictJson<Json>(readPresetText(file), where);
    if (document.is_object() && !document.contains("type")) {
        return readCamera(document, where, warnings);
    }
    LoadedPreset loaded = loadPreset(file);
    warnings.insert(warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
    if (loaded.preset.camera) return *loaded.preset.camera;
    throw Error({where, "holds no camera", "", "a \"camera\" object", ""});
}

}  // namespace neph
