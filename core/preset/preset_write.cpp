// preset_write.cpp: writes presets as JSON.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/camera/camera_format.h"
#include "core/look/parameter_format.h"
#include "core/preset/preset.h"
#include "core/preset/preset_format.h"

namespace neph {
namespace {

/// Keeps the order of keys, and floats as floats, so that they are written in their shortest form.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                  std::int64_t, std::uint64_t, float>;

Json toJson(const CameraPose& pose) {
    Json camera = Json::object();
    camera["target"] = {pose.target.x, pose.target.y, pose.target.z};
    for (const CameraKey& row : kCameraKeys) camera[std::string(row.key)] = pose.*(row.member);
    if (pose.fixedToGround) camera[std::string(kFixedKey)] = true;
    return camera;
}

/// One key per line with its whole value: easier to read and to compare than either format of
/// dump().
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

std::string formatPreset(const Preset& preset) {
    Json document = Json::object();
    document["type"] = kPresetType;
    document["version"] = kPresetVersion;
    document["title"] = preset.title;
    document["description"] = preset.description;
    document["look"] = Json::parse(formatParameters(lookTable(), {preset.look, {}}));
    if (preset.camera) document["camera"] = toJson(*preset.camera);
    return layOut(document);
}

void savePreset(const std::filesystem::path& file, const Preset& preset) {
    replaceFile(file, formatPreset(preset));
}

}  // namespace neph
