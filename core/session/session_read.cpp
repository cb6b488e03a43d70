// session_read.cpp: reads sessions from untrusted JSON; every fault becomes an Error.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/strict_json.h"
#include "core/camera/camera_format.h"
#include "core/dataset/ensemble.h"
#include "core/look/parameter_format.h"
#include "core/session/session_file.h"

namespace neph {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxBytes = std::size_t{16} << 20;  // a thousand names take 0.1 MiB
constexpr std::size_t kMaxNames = 100000;                 // of data; a long series has thousands
constexpr std::size_t kMaxNameLength = 4096;              // PATH_MAX
constexpr std::size_t kMaxBookmarks = 1000;
constexpr std::array<std::string_view, 8> kTopKeys{
    "type", "version", "active", "compare", "split_at", "linked_cameras", "linked_times", "slots"};
constexpr std::array<std::string_view, 12> kSlotKeys{"data",   "members",   "region", "preset",
                                                     "time",   "member",    "look",   "sampling",
                                                     "camera", "bookmarks", "path",   "pins"};
constexpr std::array<std::string_view, 2> kPinKeys{"label", "position_m"};
constexpr std::array<std::string_view, 2> kRegionKeys{"lower_m", "upper_m"};
constexpr std::array<std::string_view, 2> kBookmarkKeys{"name", "camera"};

/// Reads the keys of an object one by one, and reports unknown ones.
struct Reader {
    const Json& object;
    std::string where;
    std::vector<std::string>& warnings;

    /// nullptr if the key is absent.
    const Json* find(std::string_view key) const {
        const auto found = object.find(std::string(key));
        return found == object.end() ? nullptr : &*found;
    }
    void warnOfOthers(std::span<const std::string_view> known) const {
        for (const auto& [key, value] : object.items()) {
            if (std::ranges::find(known, key) == known.end()) {
                warnings.push_back(unknownJsonKey(where, key, known));
            }
        }
    }
    [[noreturn]] void refuse(std::string_view key, std::string_view expected) const {
        refuseJson(where, key, excerpt(object.at(std::string(key))), expected);
    }
    void read(std::string_view key, bool& value) const {
        const Json* json = find(key);
        if (json == nullptr) return;
        if (!json->is_boolean()) refuse(key, "true or false");
        value = json->get<bool>();
    }
    void read(std::string_view key, int& value, int last) const {
        const Json* json = find(key);
        if (json == nullptr) return;
        const bool fits = json->is_number_unsigned() &&
                          json->get<std::uint64_t>() <= static_cast<std::uint64_t>(last);
        if (!fits) refuse(key, fmt::format("a whole number from 0 to {}", last));
        value = json->get<int>();
    }
    /// A list of limited length; nullptr if the key is absent.
    const Json* list(std::string_view key, std::size_t least, std::size_t most) const {
        const Json* json = find(key);
        if (json == nullptr) return nullptr;
        if (!json->is_array() || json->size() < least || json->size() > most) {
            refuse(key, least == most ? fmt::format("a list of {}", most)
                                      : fmt::format("a list of {} to {}", least, most));
        }
        return json;
    }
};

/// The path of data named in the file, relative to the folder of the file.
std::string resolved(const std::string& name, const fs::path& folder) {
    std::error_code error;
    const bool bare = name.find('/') == name.npos && !name.starts_with('.');
    if (bare && !fs::exists(folder / name, error)) return name;  // a bundled sample
    const fs::path path = (folder / name).lexically_normal();
    return (path.has_filename() ? path : path.parent_path()).string();
}

std::vector<std::string> readNames(const Reader& slot, const fs::path& folder) {
    std::vector<std::string> names;
    const Json* list = slot.list("data", 0, kMaxNames);
    if (list == nullptr) return names;
    for (const Json& item : *list) {
        const std::string name = item.is_string() ? item.get<std::string>() : std::string();
        const bool fits =
            !name.empty() && name.size() <= kMaxNameLength && name.find('\0') == name.npos;
        if (!fits) {
            refuseJson(slot.where, "data", excerpt(item), "names of files or folders in quotes");
        }
        names.push_back(resolved(name, folder));
    }
    return names;
}

/// null stands for no limit on that side.
glm::dvec3 readCorner(const Reader& region, std::string_view key, double unbounded) {
    const Json* list = region.list(key, 3, 3);
    glm::dvec3 corner(unbounded);
    for (int i = 0; list != nullptr && i < 3; ++i) {
        const Json& item = (*list)[static_cast<std::size_t>(i)];
        if (item.is_null()) continue;
        if (!item.is_number()) region.refuse(key, "three numbers, or null for no bound");
        corner[i] = item.get<double>();
    }
    return corner;
}

std::optional<BoxM> readRegion(const Reader& slot) {
    const Json* json = slot.find("region");
    if (json == nullptr || json->is_null()) return {};
    const Reader region{jsonObject(*json, "region", slot.where), slot.where + ": region",
                        slot.warnings};
    region.warnOfOthers(kRegionKeys);
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const BoxM read{readCorner(region, "lower_m", -kFar), readCorner(region, "upper_m", kFar)};
    for (int i = 0; i < 3; ++i) {
        if (!(read.lowerM[i] < read.upperM[i])) {
            slot.refuse("region", "each of \"lower_m\" less than that of \"upper_m\"");
        }
    }
    return read;
}

std::string readName(const Reader& from, std::string_view key) {
    const std::string name = jsonText(from.object, key, from.where);
    if (name.size() > kMaxNameLength) from.refuse(key, "a shorter name");
    return name;
}

std::vector<Bookmark> readBookmarks(const Reader& slot) {
    std::vector<Bookmark> bookmarks;
    const Json* list = slot.list("bookmarks", 0, kMaxBookmarks);
    if (list == nullptr) return bookmarks;
    for (const Json& item : *list) {
        const std::string where = fmt::format("{}: bookmark {}", slot.where, bookmarks.size() + 1);
        const Reader bookmark{jsonObject(item, "bookmarks", where), where, slot.warnings};
        bookmark.warnOfOthers(kBookmarkKeys);
        const Json* camera = bookmark.find("camera");
        bookmarks.push_back(
            {readName(bookmark, "name"),
             camera == nullptr ? CameraPose{} : parseCamera(camera->dump(), where, slot.warnings)});
    }
    return bookmarks;
}

std::vector<Pin> readPins(const Reader& slot) {
    std::vector<Pin> pins;
    const Json* list = slot.list("pins", 0, kMaxPins);
    if (list == nullptr) return pins;
    for (const Json& item : *list) {
        const std::string where = fmt::format("{}: pin {}", slot.where, pins.size() + 1);
        const Reader pin{jsonObject(item, "pins", where), where, slot.warnings};
        pin.warnOfOthers(kPinKeys);
        Pin read{readName(pin, "label"), {}};
        const Json* position = pin.list("position_m", 3, 3);
        if (position == nullptr) refuseJson(where, "position_m", "nothing", "three lengths in m");
        for (int i = 0; i < 3; ++i) {
            const Json& length = position->at(static_cast<std::size_t>(i));
            if (!length.is_number()) pin.refuse("position_m", "three lengths in m");
            read.positionM[i] = length.get<double>();
        }
        pins.push_back(std::move(read));
    }
    return pins;
}

/// A path in a session lacks the header of a path file, so it is added for the parser.
CameraPath readPath(const Reader& slot) {
    const Json* json = slot.find("path");
    if (json == nullptr) return {};
    Json path = jsonObject(*json, "path", slot.where);
    path["type"] = kPathType;
    path["version"] = kPathVersion;
    return parseCameraPath(path.dump(), slot.where + ": path", slot.warnings);
}

/// Reads look and sampling. Older sessions have both in "look".
FieldSet readParameters(const Reader& slot, ParameterSet& values) {
    FieldSet inMetres = 0;
    const auto read = [&](std::string_view key, std::span<const Parameter> rows) {
        const Json* json = slot.find(key);
        if (json == nullptr) return;
        inMetres |= parseParameters(jsonObject(*json, key, slot.where).dump(), rows, slot.where,
                                    values, slot.warnings)
                        .inMetres;
    };
    read("look", parameterTable());
    read("sampling", samplingTable());
    return inMetres;
}

/// Which member of an ensemble is shown; an index that it does not have becomes one it has.
int readMemberIndex(const Reader& from) {
    const Json* json = from.find("member");
    if (json != nullptr && json->is_string() && json->get<std::string>() == "mean") {
        return kMeanMember;
    }
    if (json != nullptr && json->is_string()) from.refuse("member", "\"mean\" or a whole number");
    int member = 0;
    from.read("member", member, std::numeric_limits<int>::max());
    return member;
}

SlotState readSlot(const Reader& from, const fs::path& folder) {
    from.warnOfOthers(kSlotKeys);
    SlotState slot;
    slot.data = readNames(from, folder);
    from.read("members", slot.members);
    slot.region = readRegion(from);
    slot.presetName = readName(from, "preset");
    from.read("time", slot.document.time, std::numeric_limits<int>::max());
    slot.document.member = readMemberIndex(from);
    slot.inMetres = readParameters(from, slot.document);
    if (const Json* camera = from.find("camera")) {
        slot.document.camera = parseCamera(camera->dump(), from.where, from.warnings);
    }
    slot.document.bookmarks = readBookmarks(from);
    slot.document.pins = readPins(from);
    slot.document.path = readPath(from);
    return slot;
}

CompareMode readCompare(const Reader& from) {
    if (from.find("compare") == nullptr) return CompareMode::single;
    const std::string mode = jsonText(from.object, "compare", from.where);
    if (mode != "single" && mode != "split") from.refuse("compare", "\"single\" or \"split\"");
    return mode == "split" ? CompareMode::split : CompareMode::single;
}

float readSplit(const Reader& from, float otherwise) {
    const Json* json = from.find("split_at");
    if (json == nullptr) return otherwise;
    const double share = json->is_number() ? json->get<double>() : -1.0;
    if (!(share >= 0.0 && share <= 1.0)) from.refuse("split_at", "a number from 0 to 1");
    return static_cast<float>(share);
}

}  // namespace

SessionState parseSession(std::string_view text, std::string_view where, const fs::path& folder,
                          std::vector<std::string>& warnings) {
    const Json document = parseStrictJson<Json>(text, where);
    checkJsonHeader(document, where, "a Nephoscope session", kSessionType, 1);
    const Reader top{document, std::string(where), warnings};
    top.warnOfOthers(kTopKeys);
    SessionState state;
    const Json* slots = top.list("slots", 1, 2);
    if (slots == nullptr) {
        throw Error({std::string(where), "holds no \"slots\"", "", "a list of one or two", ""});
    }
    for (const Json& item : *slots) {
        const std::string name = fmt::format("{}: slot {}", where, state.slots.empty() ? 'A' : 'B');
        const Reader slot{jsonObject(item, "slots", name), name, warnings};
        state.slots.push_back(readSlot(slot, fs::absolute(folder)));
    }
    top.read("active", state.active, static_cast<int>(state.slots.size()) - 1);
    state.compare = readCompare(top);
    state.splitAt = readSplit(top, state.splitAt);
    top.read("linked_cameras", state.linkedCameras);
    top.read("linked_times", state.linkedTimes);
    return state;
}

SessionState loadSession(const fs::path& file, std::vector<std::string>& warnings) {
    return parseSession(readJsonText(file, "a session", kMaxBytes), file.string(),
                        fs::absolute(file).parent_path(), warnings);
}

SessionState loadSession(const fs::path& file) {
    std::vector<std::string> unheard;
    return loadSession(file, unheard);
}

}  // namespace neph
