// preset_read.cpp: reads presets from untrusted JSON; every fault becomes an Error.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/strict_json.h"
#include "core/camera/camera_format.h"
#include "core/look/parameter_format.h"
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

/// Reads the look of a preset. Sampling is named in a note, because older files held it.
void readLook(std::string_view values, std::string_view where, LoadedPreset& loaded) {
    ParameterSet read;
    std::string sampling;
    const ParsedParameters parsed =
        parseParameters(values, parameterTable(), where, read, loaded.warnings);
    loaded.inMetres = parsed.inMetres;
    if (parsed.inMetres != 0) {
        loaded.notes.push_back(fmt::format(
            "{}: noise_scale of {} is in metres, as older versions wrote it; noise_cells "
            "has it in cells of the data (of {:g} m where none are open)",
            where, namesOf(parsed.inMetres), kLookCellM));
    }
    for (const Parameter* row : parsed.named) {
        if (row->part != ParameterPart::sampling) continue;
        sampling += (sampling.empty() ? "" : ", ") + row->id;
    }
    loaded.preset.look = read.look;
    if (sampling.empty()) return;
    loaded.notes.push_back(
        fmt::format("{}: {} not taken over: how finely an image is computed is no part of a preset",
                    where, sampling));
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
            readLook(jsonObject(value, key, where).dump(), where, loaded);
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
