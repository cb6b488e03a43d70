// session_write.cpp: writes sessions as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/strict_json.h"
#include "core/camera/camera_format.h"
#include "core/dataset/ensemble.h"
#include "core/look/parameter_format.h"
#include "core/session/session_file.h"

namespace neph {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kLineLength = 100;

/// Whether data are named relative to `folder`: if they are below it or beside it.
bool movesWith(const fs::path& relative, const fs::path& folder) {
    if (relative.empty() || !folder.has_relative_path()) return false;
    auto part = relative.begin();
    if (*part != "..") return true;
    return (++part == relative.end() || *part != "..") && folder.parent_path().has_relative_path();
}

/// The name that is written to the file.
std::string nameOf(const std::string& name, const fs::path& folder) {
    std::error_code error;
    const bool bare = name.find('/') == name.npos && !name.starts_with('.');
    if (bare && !fs::exists(name, error)) return name;  // a bundled sample
    fs::path path = fs::absolute(name).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    const fs::path relative = path.lexically_relative(folder);
    if (!movesWith(relative, folder)) return path.string();
    return relative.begin()->string() == ".." ? relative.string() : "./" + relative.string();
}

/// Limits a pose to the ranges of the reader, so that every file that is written can be read again.
CameraPose bounded(CameraPose pose) {
    pose.target = TargetLimits{}.nearest(pose.target);
    for (const CameraKey& row : kCameraKeys) {
        pose.*(row.member) = std::clamp(pose.*(row.member), row.lo, row.hi);
    }
    return pose;
}

Json toJson(const CameraPose& pose) {
    return Json::parse(formatCamera(bounded(pose)));
}

Json toJson(const CameraPath& path) {
    Json json = Json::parse(formatCameraPath(path));
    json.erase("type");  // implied by its place in the session
    json.erase("version");
    return json;
}

Json toJson(const glm::dvec3& corner) {
    Json json = Json::array();
    for (int i = 0; i < 3; ++i) {
        json.push_back(std::isfinite(corner[i]) ? Json(corner[i]) : Json());
    }
    return json;
}

Json toJson(const SlotState& slot, const fs::path& folder) {
    const Document& document = slot.document;
    Json json = Json::object();
    json["data"] = Json::array();
    for (const std::string& name : slot.data) json["data"].push_back(nameOf(name, folder));
    if (slot.members) json["members"] = true;
    if (slot.region) {
        json["region"] = {{"lower_m", toJson(slot.region->lowerM)},
                          {"upper_m", toJson(slot.region->upperM)}};
    }
    json["preset"] = slot.presetName;
    json["time"] = document.time;
    if (slot.members) {
        json["member"] = document.member == kMeanMember ? Json("mean") : Json(document.member);
    }
    json["look"] = Json::parse(formatParameters(lookTable(), document));
    json["sampling"] = Json::parse(formatParameters(samplingTable(), document));
    json["camera"] = toJson(document.camera);
    json["bookmarks"] = Json::array();
    for (const Bookmark& bookmark : document.bookmarks) {
        json["bookmarks"].push_back({{"name", bookmark.name}, {"camera", toJson(bookmark.pose)}});
    }
    json["path"] = toJson(document.path);
    json["pins"] = Json::array();
    for (const Pin& pin : document.pins) {
        json["pins"].push_back({{"label", pin.label}, {"position_m", toJson(pin.positionM)}});
    }
    return json;
}

std::string onOneLine(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Values that fit on one line are written on one.
void layOut(const Json& value, const std::string& indent, std::string& out) {
    const std::string line = onOneLine(value);
    if (value.empty() || !value.is_structured() || (line.size() < kLineLength && !indent.empty())) {
        out += line;
        return;
    }
    const bool isObject = value.is_object();
    const std::string deeper = indent + "  ";
    std::string comma;
    out += isObject ? "{" : "[";
    for (const auto& [key, item] : value.items()) {
        out += comma + "\n" + deeper;
        if (isObject) out += onOneLine(Json(key)) + ": ";
        layOut(item, deeper, out);
        comma = ",";
    }
    out += "\n" + indent + (isObject ? "}" : "]");
}

}  // namespace

std::string formatSession(const SessionState& state, const fs::path& folder) {
    const fs::path from = fs::absolute(folder).lexically_normal();
    Json json = Json::object();
    json["type"] = kSessionType;
    json["version"] = 1;
    json["active"] = state.active;
    json["compare"] = state.compare == CompareMode::split ? "split" : "single";
    json["split_at"] = asWritten(state.splitAt);
    json["linked_cameras"] = state.linkedCameras;
    json["linked_times"] = state.linkedTimes;
    json["slots"] = Json::array();
    for (const SlotState& slot : state.slots) json["slots"].push_back(toJson(slot, from));
    std::string text;
    layOut(json, "", text);
    return text + "\n";
}

void saveSession(const fs::path& file, const SessionState& state) {
    replaceFile(file, formatSession(state, fs::absolute(file).parent_path()));
}

}  // namespace neph
