// settings.cpp: reads and writes one JSON object of `type` nephoscope-settings, version 1.
#include "core/session/settings.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/base/strict_json.h"
#include "core/session/recent.h"

namespace neph {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kType = "nephoscope-settings";
constexpr int kVersion = 1;
constexpr std::size_t kMaxBytes = std::size_t{4} << 20;  // it holds the paths of recent files

std::optional<std::filesystem::path> settingsFile() {
    const auto folder = userConfigDir();
    if (!folder) return {};
    return *folder / "settings.json";
}

/// The object in the file; empty if there is no file. Throws Error if it is not a settings file.
std::optional<Json> readObject(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return {};
    try {
        const std::string where = file.string();
        const auto json = parseStrictJson<Json>(readJsonText(file, "settings", kMaxBytes), where);
        checkJsonHeader(json, where, "a file of settings", kType, kVersion);
        return json;
    } catch (const Error& fault) {
        ErrorParts parts = fault.parts();
        parts.hint = "remove it to start again";
        throw Error(parts);
    }
}

bool take(const Json& json, std::string& value) {
    if (json.is_string()) value = json.get<std::string>();
    return json.is_string();
}
bool take(const Json& json, bool& value) {
    if (json.is_boolean()) value = json.get<bool>();
    return json.is_boolean();
}
/// null: not decided.
bool take(const Json& json, std::optional<bool>& value) {
    if (json.is_null()) value.reset();
    if (json.is_boolean()) value = json.get<bool>();
    return json.is_null() || json.is_boolean();
}
template <typename Number>
bool take(const Json& json, Number& value, double lo, double hi) {
    const bool fits = json.is_number() && json.get<double>() >= lo && json.get<double>() <= hi;
    if (fits) value = static_cast<Number>(json.get<double>());
    return fits;
}
bool take(const Json& json, Theme& value) {
    if (json != "dark" && json != "light") return false;
    value = json == "light" ? Theme::light : Theme::dark;
    return true;
}
bool take(const Json& json, std::vector<std::string>& value) {
    if (!json.is_array() || json.size() > kMaxRecent) return false;
    std::vector<std::string> read(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (!take(json[i], read[i])) return false;
    }
    value = std::move(read);
    return true;
}

/// null: none.
bool take(const Json& json, std::optional<WindowPlace>& value) {
    if (json.is_null()) value.reset();
    if (!json.is_array() || json.size() != 4) return json.is_null();
    constexpr double kMost = 65535.0;  // as far as screens go
    WindowPlace read;
    const bool fits =
        take(json[0], read.x, -kMost, kMost) && take(json[1], read.y, -kMost, kMost) &&
        take(json[2], read.width, 1.0, kMost) && take(json[3], read.height, 1.0, kMost);
    if (fits) value = read;
    return fits;
}
Json asJson(const std::optional<WindowPlace>& place) {
    if (!place) return {};
    return Json::array({place->x, place->y, place->width, place->height});
}

/// A setting; the only place where its key is written.
struct Row {
    const char* key;
    const char* expected;
    bool (*read)(const Json&, Settings&);
    Json (*write)(const Settings&);
};

template <bool Settings::*member>
constexpr Row switchRow(const char* key) {
    return {key, "true or false", [](const Json& j, Settings& s) { return take(j, s.*member); },
            [](const Settings& s) { return Json(s.*member); }};
}

template <float Settings::*member>
constexpr Row columnRow(const char* key) {
    return {key, "a number from 15 to 40",
            [](const Json& j, Settings& s) {
                return take(j, s.*member, static_cast<double>(kLeastColumnEms),
                            static_cast<double>(kMostColumnEms));
            },
            [](const Settings& s) { return Json(asWritten(s.*member)); }};
}

constexpr std::array kRows{
    Row{"memory", "text such as \"2GiB\"",
        [](const Json& j, Settings& s) { return take(j, s.memory); },
        [](const Settings& s) { return Json(s.memory); }},
    Row{"theme", "\"dark\" or \"light\"",
        [](const Json& j, Settings& s) { return take(j, s.theme); },
        [](const Settings& s) { return Json(s.theme == Theme::light ? "light" : "dark"); }},
    Row{"text_scale", "a number from 0.5 to 4",
        [](const Json& j, Settings& s) { return take(j, s.textScale, 0.5, 4.0); },
        [](const Settings& s) { return Json(asWritten(s.textScale)); }},
    Row{"frames_per_second", "a number from 1 to 240",
        [](const Json& j, Settings& s) { return take(j, s.framesPerSecond, 1.0, 240.0); },
        [](const Settings& s) { return Json(s.framesPerSecond); }},
    switchRow<&Settings::leftColumn>("left_column"),
    switchRow<&Settings::rightColumn>("right_column"),
    columnRow<&Settings::leftColumnEms>("left_column_letters"),
    columnRow<&Settings::rightColumnEms>("right_column_letters"),
    switchRow<&Settings::dataDetails>("data_details"),
    Row{"window", "[x, y, width, height] or null",
        [](const Json& j, Settings& s) { return take(j, s.window); },
        [](const Settings& s) { return asJson(s.window); }},
    switchRow<&Settings::scaleBar>("scale_bar"),
    switchRow<&Settings::compass>("compass"),
    switchRow<&Settings::heightRuler>("height_ruler"),
    Row{"measure_at_rest", "true, false or null",
        [](const Json& j, Settings& s) { return take(j, s.measureAtRest); },
        [](const Settings& s) { return s.measureAtRest ? Json(*s.measureAtRest) : Json(); }},
    switchRow<&Settings::denoisedPreview>("denoised_preview"),
    Row{"recent", "a list of at most 12 names",
        [](const Json& j, Settings& s) { return take(j, s.recent); },
        [](const Settings& s) { return Json(s.recent); }},
};

}  // namespace

Settings loadSettings(std::vector<std::string>& warnings) {
    Settings settings;
    const auto file = settingsFile();
    if (!file) return settings;
    try {
        const auto json = readObject(*file);
        for (const Row& row : kRows) {
            if (!json || !json->contains(row.key) || row.read(json->at(row.key), settings))
                continue;
            warnings.push_back(
                fmt::format("{}: \"{}\" cannot take {}; the default is used instead\n"
                            "       expected: {}",
                            file->string(), row.key, excerpt(json->at(row.key)), row.expected));
        }
    } catch (const Error& error) {
        warnings.push_back(error.message());
    }
    return settings;
}

bool settingsWereSaved() {
    const auto file = settingsFile();
    std::error_code error;
    return !file || std::filesystem::exists(*file, error);
}

void saveSettings(const Settings& settings) {
    const auto file = settingsFile();
    if (!file) {
        throw Error({"", "settings cannot be remembered", "no home folder", "",
                     "set XDG_CONFIG_HOME or HOME"});
    }
    Json json = readObject(*file).value_or(Json{{"type", kType}, {"version", kVersion}});
    for (const Row& row : kRows) json[row.key] = row.write(settings);
    std::error_code error;
    std::filesystem::create_directories(file->parent_path(), error);
    replaceFile(*file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace neph
