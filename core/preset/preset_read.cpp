// preset_read.cpp: reads presets from untrusted JSON; every fault becomes an Error.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/strict_json.h"
#include "core/camera/camera_format.h"
#include "core/preset/preset.h"
#include "core/preset/preset_format.h"

namespace neph {
namespace {

/// Keeps the order of keys. Numbers are stored as float, so that a float written in its shortest
/// form is read back with the same bits.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                  std::int64_t, std::uint64_t, float>;

constexpr std::size_t kMaxJsonBytes = std::size_t{1} << 20;  // a typical preset has 8 KiB
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

/// Choices are written by name, so that files survive a change of the enumeration.
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

/// The value in the type of the parameter; empty if JSON has another type.
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
            loaded.preset.camera = parseCamera(value.dump(), where, loaded.warnings);
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
    const std::string content = readPresetText(file);
    const Json document = parseStrictJson<Json>(content, where);
    if (document.is_object() && !document.contains("type")) {
        return parseCamera(content, where, warnings);
    }
    LoadedPreset loaded = parsePreset(content, where);
    warnings.insert(warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
    if (loaded.preset.camera) return *loaded.preset.camera;
    throw Error({where, "holds no camera", "", "a \"camera\" object", ""});
}

}  // namespace neph
