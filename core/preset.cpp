// preset.cpp: JSON of a look, in both directions.
#include "core/preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/names.h"
#include "core/strict_json.h"

namespace neph {
namespace {

constexpr std::string_view kType = "nephoscope-look";
constexpr int kVersion = 1;
constexpr std::array<std::string_view, 6> kTopKeys{"type",        "version", "title",
                                                   "description", "look",    "camera"};

/// A number of the camera object: the single spelling of its key and range.
struct CameraKey {
    std::string_view key;
    float CameraPose::*member;
    float lo, hi;
};
constexpr std::array kCameraKeys{
    CameraKey{"distance", &CameraPose::distance, kMinDistance, kMaxDistance},
    CameraKey{"azimuth_deg", &CameraPose::azimuthDeg, -360.0f, 360.0f},
    CameraKey{"elevation_deg", &CameraPose::elevationDeg, -90.0f, 90.0f},
    CameraKey{"fov_deg", &CameraPose::fovDeg, kMinFovDeg, kMaxFovDeg},
};
constexpr float kMinTarget = -1.0f, kMaxTarget = 2.0f;  // as far as pan() goes

std::string unknownKey(std::string_view where, std::string_view key,
                       std::span<const std::string_view> known) {
    const std::string_view near = nearestName(key, known);
    std::string text = fmt::format("{}: key \"{}\" is not known and was left out", where, key);
    if (!near.empty()) text += fmt::format("; did you mean \"{}\"?", near);
    return text;
}

const Json& object(const Json& value, std::string_view key, std::string_view where) {
    if (value.is_object()) return value;
    throw Error({std::string(where), fmt::format("\"{}\" is of the wrong type", key),
                 excerpt(value), "an object in braces", ""});
}

std::string text(const Json& document, std::string_view key, std::string_view where) {
    const auto found = document.find(std::string(key));
    if (found == document.end()) return {};
    if (found->is_string()) return found->get<std::string>();
    throw Error({std::string(where), fmt::format("\"{}\" is of the wrong type", key),
                 excerpt(*found), "text in quotes", ""});
}

// ---- reading ------------------------------------------------------------------------------------

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
            warnings.push_back(unknownKey(where, key, known));
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
        const auto row = std::find_if(kCameraKeys.begin(), kCameraKeys.end(),
                                      [&](const CameraKey& r) { return r.key == key; });
        if (key == "target") {
            pose.target = cameraTarget(value, where);
        } else if (row != kCameraKeys.end()) {
            pose.*(row->member) = cameraNumber(value, key, row->lo, row->hi, where);
        } else {
            warnings.push_back(unknownKey(where, key, known));
        }
    }
    return pose;
}

void checkHeader(const Json& document, std::string_view where) {
    const auto type = document.find("type");
    if (type == document.end() || *type != kType) {
        throw Error({std::string(where), "is not a Nephoscope preset",
                     type == document.end() ? "no \"type\"" : "type " + excerpt(*type),
                     fmt::format("\"type\": \"{}\"", kType), ""});
    }
    const auto version = document.find("version");
    if (version == document.end() || *version != kVersion) {
        throw Error({std::string(where), "is of a version that is not known",
                     version == document.end() ? "no \"version\"" : "version " + excerpt(*version),
                     fmt::format("\"version\": {}", kVersion), ""});
    }
}

// ---- writing ------------------------------------------------------------------------------------

Json toJson(const glm::vec3& v) {
    return Json::array({v.x, v.y, v.z});
}

Json toJson(const Parameter& row, const ParameterValue& value) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return std::get<bool>(value);
        case ParameterKind::integer:
            return std::get<int>(value);
        case ParameterKind::choice:
            return formatValue(row, value);
        case ParameterKind::colour:
            return toJson(std::get<glm::vec3>(value));
        case ParameterKind::number:
            break;
    }
    return std::get<float>(value);
}

Json toJson(const CameraPose& pose) {
    Json camera = Json::object();
    camera["target"] = toJson(pose.target);
    for (const CameraKey& row : kCameraKeys) camera[std::string(row.key)] = pose.*(row.member);
    return camera;
}

/// One key a line, values on their line: easier to read and to compare than either of dump()'s.
std::string layOut(const Json& document) {
    std::string out = "{";
    std::string_view comma = "\n";
    for (const auto& [key, value] : document.items()) {
        out += fmt::format("{}  {}: ", comma, Json(key).dump());
        comma = ",\n";
        if (!value.is_object()) {
            out += value.dump();
            continue;
        }
        out += "{";
        std::string_view inner = "\n";
        for (const auto& [name, item] : value.items()) {
            out += fmt::format("{}    {}: {}", inner, Json(name).dump(), item.dump());
            inner = ",\n";
        }
        out += "\n  }";
    }
    return out + "\n}\n";
}

}  // namespace

LoadedPreset parsePreset(std::string_view content, std::string_view where) {
    const Json document = parseStrictJson(content, where);
    if (!document.is_object()) {
        throw Error({std::string(where), "is not a Nephoscope preset", excerpt(document),
                     "an object in braces", ""});
    }
    checkHeader(document, where);
    LoadedPreset loaded;
    loaded.preset.title = text(document, "title", where);
    loaded.preset.description = text(document, "description", where);
    for (const auto& [key, value] : document.items()) {
        if (key == "look") {
            readLook(object(value, key, where), loaded.preset.look, where, loaded.warnings);
        } else if (key == "camera") {
            loaded.preset.camera = readCamera(object(value, key, where), where, loaded.warnings);
        } else if (std::find(kTopKeys.begin(), kTopKeys.end(), key) == kTopKeys.end()) {
            loaded.warnings.push_back(unknownKey(where, key, kTopKeys));
        }
    }
    return loaded;
}

LoadedPreset loadPreset(const std::filesystem::path& file) {
    return parsePreset(readSmallFile(file), file.string());
}

std::string formatPreset(const Preset& preset) {
    Json document = Json::object();
    document["type"] = kType;
    document["version"] = kVersion;
    document["title"] = preset.title;
    document["description"] = preset.description;
    Json look = Json::object();
    for (const Parameter& row : lookTable()) look[row.id] = toJson(row, valueOf(preset.look, row));
    document["look"] = std::move(look);
    if (preset.camera) document["camera"] = toJson(*preset.camera);
    return layOut(document);
}

void savePreset(const std::filesystem::path& file, const Preset& preset) {
    replaceFile(file, formatPreset(preset));
}

CameraPose loadCamera(std::string_view nameOrFile, std::vector<std::string>& warnings) {
    const std::filesystem::path file = findPreset(nameOrFile);
    const std::string where = file.string();
    const Json document = parseStrictJson(readSmallFile(file), where);
    if (document.is_object() && !document.contains("type")) {
        return readCamera(document, where, warnings);
    }
    LoadedPreset loaded = loadPreset(file);
    warnings.insert(warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
    if (loaded.preset.camera) return *loaded.preset.camera;
    throw Error({where, "holds no camera", "", "a \"camera\" object", ""});
}

}  // namespace neph
