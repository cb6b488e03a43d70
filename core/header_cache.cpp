// header_cache.cpp: descriptions as JSON. What the files of a series say alike is written once.
#include "core/header_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/resources.h"

namespace neph {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int kVersion = 1;                        // raised with every change of what is written
constexpr std::size_t kMostFolders = 64;           // cache files that are kept
constexpr std::uintmax_t kMostBytes = 32U << 20U;  // of one cache file

/// FNV-1a, 64 bit. [Fowler]
std::uint64_t hashOf(std::string_view text) {
    std::uint64_t hash = 14695981039346656037U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return hash;
}

/// The first line of a cache file.
std::string checksumOf(std::string_view body) {
    return fmt::format("{:016x}\n", hashOf(body));
}
constexpr std::size_t kChecksumLength = 17;

Json toJson(const FileVariable& variable) {
    return {variable.name,        variable.standardName, variable.units,
            variable.description, variable.role,         variable.species,
            variable.size.x,      variable.size.y,       variable.size.z};
}

FileVariable variableOf(const Json& json) {
    return {json.at(0),
            json.at(1),
            json.at(2),
            json.at(3),
            json.at(4),
            json.at(5),
            {json.at(6), json.at(7), json.at(8)}};
}

/// Everything but the times.
Json commonOf(const FileDescription& description) {
    Json variables = Json::array();
    for (const FileVariable& variable : description.variables) {
        variables.push_back(toJson(variable));
    }
    return {{"model", description.model},
            {"scheme", description.scheme},
            {"microphysics", description.microphysics},
            {"droplets", description.cloudDropletsPerM3},
            {"size", {description.size.x, description.size.y, description.size.z}},
            {"spacing", {description.spacingM.x, description.spacingM.y}},
            {"variables", std::move(variables)},
            {"notes", description.notes},
            {"attributes", description.attributes}};
}

FileDescription descriptionOf(const Json& json) {
    FileDescription description;
    json.at("model").get_to(description.model);
    json.at("scheme").get_to(description.scheme);
    json.at("microphysics").get_to(description.microphysics);
    json.at("droplets").get_to(description.cloudDropletsPerM3);
    for (int axis = 0; axis < 3; ++axis) {
        description.size[axis] = json.at("size").at(static_cast<std::size_t>(axis));
    }
    for (int axis = 0; axis < 2; ++axis) {
        description.spacingM[axis] = json.at("spacing").at(static_cast<std::size_t>(axis));
    }
    for (const Json& variable : json.at("variables")) {
        description.variables.push_back(variableOf(variable));
    }
    json.at("notes").get_to(description.notes);
    json.at("attributes").get_to(description.attributes);
    return description;
}

/// Makes room for one more cache file.
void prune(const fs::path& cacheFolder) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (const auto& entry : fs::directory_iterator(cacheFolder)) {
        if (entry.path().extension() == ".json") {
            files.emplace_back(entry.last_write_time(), entry.path());
        }
    }
    std::ranges::sort(files);
    for (std::size_t i = 0; i + kMostFolders <= files.size(); ++i) fs::remove(files[i].second);
}

}  // namespace

std::optional<HeaderStamp> headerStampOf(const fs::path& file) {
    std::error_code code;
    if (!fs::is_regular_file(file, code)) return {};
    const auto bytes = fs::file_size(file, code);
    if (code) return {};
    const auto changed = fs::last_write_time(file, code);
    if (code) return {};
    return HeaderStamp{bytes, std::chrono::nanoseconds(changed.time_since_epoch()).count()};
}

fs::path HeaderCache::standardFolder() {
    const auto folder = userCacheDir();
    return folder ? *folder / "headers" : fs::path();
}

HeaderCache::HeaderCache(fs::path cacheFolder, const fs::path& dataFolder,
                         const ReaderPlugin& reader) {
    std::error_code code;
    folder_ = fs::absolute(dataFolder.empty() ? fs::path(".") : dataFolder, code)
                  .lexically_normal()
                  .string();
    const HeaderStamp library = headerStampOf(reader.library).value_or(HeaderStamp{});
    reader_ =
        fmt::format("{} {} {} {}", reader.id, reader.version, library.bytes, library.changedNs);
    if (cacheFolder.empty()) return;
    cacheFile_ = cacheFolder / fmt::format("{:016x}.json", hashOf(folder_ + reader.id));
    try {
        load();
    } catch (const std::exception&) {
        entries_.clear();  // of another make: it is written anew
    }
}

void HeaderCache::load() {
    const auto stamp = headerStampOf(cacheFile_);
    if (!stamp || stamp->bytes > kMostBytes) return;
    std::ifstream in(cacheFile_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t body = std::min(kChecksumLength, text.size());
    if (text.substr(0, body) != checksumOf(std::string_view(text).substr(body))) return;
    const Json json = Json::parse(text.substr(body));
    if (json.at("version") != kVersion || json.at("folder") != folder_ ||
        json.at("reader") != reader_) {
        return;
    }
    std::vector<FileDescription> common;
    for (const Json& entry : json.at("common")) common.push_back(descriptionOf(entry));
    for (const auto& [name, file] : json.at("files").items()) {
        Entry entry{{file.at("bytes"), file.at("changed")},
                    common.at(file.at("common").get<std::size_t>())};
        for (const Json& time : file.at("times")) {
            entry.description.times.push_back({time.at(0), time.at(1)});
        }
        if (!entry.description.times.empty()) entries_[name] = std::move(entry);
    }
}

std::optional<FileDescription> HeaderCache::find(const fs::path& file,
                                                 const HeaderStamp& stamp) const {
    const auto found = entries_.find(file.filename().string());
    if (found == entries_.end() || found->second.stamp != stamp) return {};
    return found->second.description;
}

void HeaderCache::put(const fs::path& file, const HeaderStamp& stamp, FileDescription description) {
    entries_[file.filename().string()] = {stamp, std::move(description)};
    changed_ = true;
}

void HeaderCache::save() const {
    if (!changed_ || cacheFile_.empty()) return;
    try {
        Json common = Json::array();
        Json files = Json::object();
        for (const auto& [name, entry] : entries_) {
            if (headerStampOf(fs::path(folder_) / name) != entry.stamp) continue;
            Json shared = commonOf(entry.description);
            auto place = std::ranges::find(common, shared);
            const auto index = static_cast<std::size_t>(place - common.begin());
            if (index == common.size()) common.push_back(std::move(shared));
            Json times = Json::array();
            for (const FileTime& time : entry.description.times) {
                times.push_back({time.label, time.seconds});
            }
            files[name] = {{"bytes", entry.stamp.bytes},
                           {"changed", entry.stamp.changedNs},
                           {"common", index},
                           {"times", std::move(times)}};
        }
        const Json json{{"version", kVersion},
                        {"folder", folder_},
                        {"reader", reader_},
                        {"common", common},
                        {"files", files}};
        fs::create_directories(cacheFile_.parent_path());
        if (!fs::exists(cacheFile_)) prune(cacheFile_.parent_path());
        const std::string body = json.dump();
        replaceFile(cacheFile_, checksumOf(body) + body);
    } catch (const Json::exception&) {  // names that are not UTF-8
    } catch (const Error&) {
    } catch (const fs::filesystem_error&) {
    }
}

}  // namespace neph
