// settings.cpp: one JSON object; `type` nephoscope-settings, version 1.
#include "core/settings.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/resources.h"

namespace neph {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kType = "nephoscope-settings";
constexpr int kVersion = 1;

std::optional<std::filesystem::path> settingsFile() {
    const auto folder = userConfigDir();
    if (!folder) return {};
    return *folder / "settings.json";
}

/// The object in the file; none where there is no file. Throws Error where it is none of ours.
std::optional<Json> readObject(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) return {};
    Json json = Json::parse(stream, nullptr, false);
    if (!json.is_object() || json.value("type", Json()) != Json(kType)) {
        throw Error({file.string(), "is no file of settings", "",
                     fmt::format("JSON with \"type\": \"{}\"", kType), "remove it to start anew"});
    }
    const Json version = json.value("version", Json());
    if (!version.is_number_integer() || version.get<int>() != kVersion) {
        throw Error({file.string(), "is of another version", version.dump(),
                     std::to_string(kVersion), "remove it to start anew"});
    }
    return json;
}

}  // namespace

Settings loadSettings(std::vector<std::string>& warnings) {
    Settings settings;
    const auto file = settingsFile();
    if (!file) return settings;
    try {
        const auto json = readObject(*file);
        if (!json || !json->contains("memory")) return settings;
        const Json& memory = json->at("memory");
        if (!memory.is_string()) {
            throw Error({file->string(), "memory is no text", memory.dump(), "\"2GiB\"", ""});
        }
        settings.memory = memory.get<std::string>();
    } catch (const Error& error) {
        warnings.push_back(error.message());
    }
    return settings;
}

void saveSettings(const Settings& settings) {
    const auto file = settingsFile();
    if (!file) {
        throw Error({"", "settings cannot be remembered", "no home folder", "",
                     "set XDG_CONFIG_HOME or HOME"});
    }
    Json json = readObject(*file).value_or(Json{{"type", kType}, {"version", kVersion}});
    json["memory"] = settings.memory;
    std::error_code error;
    std::filesystem::create_directories(file->parent_path(), error);
    replaceFile(*file, json.dump(2) + "\n");
}

}  // namespace neph
