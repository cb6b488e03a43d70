// camera_format.cpp: reads cameras and paths from untrusted JSON, and writes them.
#include "core/camera/camera_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/strict_json.h"

namespace neph {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxPathBytes = std::size_t{1} << 20;  // 1000 keys take 160 KiB
constexpr std::array<std::string_view, 4> kPathKeys{"type", "version", "with_time", "keys"};
constexpr std::array<std::string_view, 2> kKeyKeys{"at_s", "camera"};

/// The float that was written: the double of JSON is rounded once.
float cameraNumber(const Json& value, const CameraKey& row, std::string_view where) {
    if (value.is_number()) {
        const auto number = static_cast<float>(value.get<double>());
        if (number >= row.lo && number <= row.hi) return number;
    }
    throw Error({std::string(where), fmt::format("camera \"{}\" cannot take this value", row.key),
                 excerpt(value), fmt::format("a number from {} to {}", row.lo, row.hi), ""});
}

glm::vec3 cameraTarget(const Json& value, std::string_view where) {
    const TargetLimits limits;
    bool fits = value.is_array() && value.size() == 3;
    glm::vec3 target{0.0f};
    for (int i = 0; fits && i < 3; ++i) {
        const Json& item = value[static_cast<std::size_t>(i)];
        fits = item.is_number();
        if (fits) target[i] = static_cast<float>(item.get<double>());
        fits = fits && target[i] >= limits.lower[i] && target[i] <= limits.upper[i];
    }
    if (fits) return target;
    throw Error({std::string(where), "camera \"target\" cannot take this value", excerpt(value),
                 fmt::format("three numbers, two from {} to {} and one from {} to {}",
                             limits.lower.x, limits.upper.x, limits.lower.z, limits.upper.z),
                 ""});
}

CameraPose readCamera(const Json& values, std::string_view where,
                      std::vector<std::string>& warnings) {
    CameraPose pose;
    std::vector<std::string_view> known{"target", kFixedKey};
    for (const CameraKey& row : kCameraKeys) known.push_back(row.key);
    const auto fixed = values.find(std::string(kFixedKey));
    if (fixed != values.end()) {
        if (!fixed->is_boolean()) refuseJson(where, kFixedKey, excerpt(*fixed), "true or false");
        pose.fixedToGround = fixed->get<bool>();
    }
    for (const auto& [key, value] : values.items()) {
        const auto row = std::ranges::find(kCameraKeys, key, &CameraKey::key);
        if (key == "target") {
            pose.target = cameraTarget(value, where);
        } else if (row != kCameraKeys.end()) {
            pose.*(row->member) = cameraNumber(value, *row, where);
        } else if (key != kFixedKey) {
            warnings.push_back(unknownJsonKey(where, key, known));
        }
    }
    return pose;
}

void warnOfOthers(const Json& object, std::span<const std::string_view> known,
                  std::string_view where, std::vector<std::string>& warnings) {
    for (const auto& [key, value] : object.items()) {
        if (std::ranges::find(known, key) == known.end()) {
            warnings.push_back(unknownJsonKey(where, key, known));
        }
    }
}

/// Times must increase strictly: the spline divides by their differences.
PathKey readKey(const Json& value, double afterS, const std::string& where,
                std::vector<std::string>& warnings) {
    if (!value.is_object() || !value.contains("at_s") || !value.contains("camera")) {
        throw Error({where, "is not a place on a path", excerpt(value),
                     "{\"at_s\": seconds, \"camera\": {...}}", ""});
    }
    const Json& at = value["at_s"];
    const double atS = at.is_number() ? at.get<double>() : -1.0;
    if (!(atS >= 0.0 && atS > afterS && atS <= kMaxPathS)) {
        refuseJson(where, "at_s", excerpt(at),
                   fmt::format(
                       "seconds up to {}, {} {}", kMaxPathS,
                       afterS < 0.0 ? "from" : "more than the key before:", std::max(afterS, 0.0)));
    }
    warnOfOthers(value, kKeyKeys, where, warnings);
    return {atS, readCamera(jsonObject(value["camera"], "camera", where), where, warnings)};
}

}  // namespace

std::string formatCamera(const CameraPose& pose) {
    std::string text =
        fmt::format(R"({{"target": [{}, {}, {}])", pose.target.x, pose.target.y, pose.target.z);
    for (const CameraKey& row : kCameraKeys) {
        text += fmt::format(R"(, "{}": {})", row.key, pose.*(row.member));
    }
    if (pose.fixedToGround) text += fmt::format(R"(, "{}": true)", kFixedKey);
    return text + "}";
}

CameraPose parseCamera(std::string_view json, std::string_view where,
                       std::vector<std::string>& warnings) {
    const Json camera = parseStrictJson<Json>(json, where);
    return readCamera(jsonObject(camera, "camera", where), where, warnings);
}

std::string formatCameraPath(const CameraPath& path) {
    std::string text = fmt::format(
        "{{\n  \"type\": \"{}\",\n  \"version\": {},\n  \"with_time\": {},\n  \"keys\": [",
        kPathType, kPathVersion, path.withTime);
    std::string_view comma = "\n";
    for (const PathKey& key : path.keys) {
        text += fmt::format(R"({}    {{"at_s": {}, "camera": {}}})", comma, key.atS,
                            formatCamera(key.pose));
        comma = ",\n";
    }
    return text + (path.keys.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

CameraPath parseCameraPath(std::string_view json, std::string_view where,
                           std::vector<std::string>& warnings) {
    const auto document = parseStrictJson<Json>(json, where);
    checkJsonHeader(document, where, "a camera path", kPathType, kPathVersion);
    warnOfOthers(document, kPathKeys, where, warnings);
    CameraPath path;
    const Json withTime = document.value("with_time", Json(path.withTime));
    const Json keys = document.value("keys", Json());
    if (!withTime.is_boolean()) refuseJson(where, "with_time", excerpt(withTime), "true or false");
    if (!keys.is_array() || keys.size() > kMaxPathKeys) {
        refuseJson(where, "keys", excerpt(keys),
                   fmt::format("a list of at most {} places", kMaxPathKeys));
    }
    path.withTime = withTime.get<bool>();
    double afterS = -1.0;
    for (const Json& key : keys) {
        const auto name = fmt::format("{}: key {}", where, path.keys.size() + 1);
        path.keys.push_back(readKey(key, afterS, name, warnings));
        afterS = path.keys.back().atS;
    }
    return path;
}

CameraPath loadCameraPath(const std::filesystem::path& file, std::vector<std::string>& warnings) {
    return parseCameraPath(readJsonText(file, "a camera path", kMaxPathBytes), file.string(),
                           warnings);
}

void saveCameraPath(const std::filesystem::path& file, const CameraPath& path) {
    replaceFile(file, formatCameraPath(path));
}

}  // namespace neph
