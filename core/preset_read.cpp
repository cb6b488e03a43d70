// preset_read.cpp: presets out of JSON from strangers; every fault becomes an Error.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"
#include "core/names.h"
#include "core/preset.h"
#include "core/preset_format.h"

namespace neph {
namespace {

/// Keeps the order of keys. Numbers are kept as float, so that a float written in its shortest form
/// reads back bit for bit.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                  std::int64_t, std::uint64_t, float>;

constexpr std::size_t kMaxJsonBytes = std::size_t{1} << 20;  // a preset has 8 KiB
constexpr int kMaxJsonDepth = 16;                            // a preset has 3
constexpr std::array<std::string_view, 6> kTopKeys{"type",        "version", "title",
                                                   "description", "look",    "camera"};

/// Watches the parser's events: the depth of nesting, and the keys seen in each open object.
class Watch {
  public:
    explicit Watch(std::string_view where) : where_(where) {}

    bool operator()(int depth, Json::parse_event_t event, Json& value) {
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) open(depth);
        if (event == Event::object_end || event == Event::array_end) keys_.pop_back();
        if (event == Event::key) addKey(value.get_ref<const std::string&>());
        return true;
    }

  private:
    void open(int depth) {
        if (depth >= kMaxJsonDepth) {
            throw Error({where_, "is nested too deeply",
                         fmt::format("more than {} levels", kMaxJsonDepth), "at most 3 levels",
                         ""});
        }
        keys_.emplace_back();
    }
    void addKey(const std::string& key) {
        if (keys_.back().insert(key).second) return;
        throw Error({where_, fmt::format("key \"{}\" stands twice", key), "", "each key once",
                     "remove one of the two"});
    }

    std::string where_;
    std::vector<std::set<std::string>> keys_;
};

std::string withoutPrefix(std::string_view message) {
    const std::size_t bracket = message.find("] ");
    return std::string(bracket == std::string_view::npos ? message : message.substr(bracket + 2));
}

Json parseStrictJson(std::string_view text, std::string_view where) {
    try {
        return Json::parse(text.begin(), text.end(), Watch(where));
    } catch (const Json::exception& fault) {
        throw Error({std::string(where), "is not valid JSON", withoutPrefix(fault.what()), "", ""});
    }
}

std::string readSmallFile(const std::filesystem::path& file) {
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) {
        throw Error({file.string(), "cannot be read", "a folder", "a JSON file", ""});
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw Error({file.string(), "cannot be read", std::strerror(errno), "", ""});
    std::string text(kMaxJsonBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    if (text.size() > kMaxJsonBytes) {
        throw Error({file.string(), "is too large for a preset", "more than 1 MiB",
                     "a JSON file of a few KiB", ""});
    }
    return text;
}

std::string excerpt(const Json& value) {
    constexpr std::size_t kLength = 60;
    std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    if (text.size() > kLength) text = text.substr(0, kLength) + " ...";
    return text;
}

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
        const auto row = std::ranges::find(kCameraKeys, key, &CameraKey::key);
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
    if (type == document.end() || *type != kPresetType) {
        throw Error({std::string(where), "is not a Nephoscope preset",
                     type == document.end() ? "no \"type\"" : "type " + excerpt(*type),
                     fmt::format("\"type\": \"{}\"", kPresetType), ""});
    }
    const auto version = document.find("version");
    if (version == document.end() || *version != kPresetVersion) {
        throw Error({std::string(where), "is of a version that is not known",
                     version == document.end() ? "no \"version\"" : "version " + excerpt(*version),
                     fmt::format("\"version\": {}", kPresetVersion), ""});
    }
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
