// header_cache.cpp: descriptions in the format of the reader processes. What the files of a series
// have in common is written once.
#include "core/dataset/header_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/resources.h"
#include "core/plugin/reader_wire.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kVersion = 10;  // increase it with every change of the format
constexpr std::string_view kExtension = ".headers";
constexpr std::size_t kMostFolders = 64;           // number of cache files that are kept
constexpr std::uintmax_t kMostBytes = 32U << 20U;  // size of one cache file

/// The first line of a cache file: it detects damage, not tampering.
std::string checksumOf(std::string_view body) {
    return fmt::format("{:016x}\n", hashOf(body));
}
constexpr std::size_t kChecksumLength = 17;

/// Removes the oldest cache files to make room for one more.
void prune(const fs::path& cacheFolder) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (const auto& entry : fs::directory_iterator(cacheFolder)) {
        if (entry.path().extension() == kExtension) {
            files.emplace_back(entry.last_write_time(), entry.path());
        }
    }
    std::ranges::sort(files);
    for (std::size_t i = 0; i + kMostFolders <= files.size(); ++i) fs::remove(files[i].second);
}

HeaderStamp stampOfParts(const DatasetInfo& description) {
    HeaderStamp all;
    for (const fs::path& part : description.parts) {
        const HeaderStamp stamp = headerStampOf(part).value_or(HeaderStamp{});
        all.bytes += stamp.bytes;
        all.changedNs = std::max(all.changedNs, stamp.changedNs);
    }
    return all;
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
                         const ReaderName& reader) {
    std::error_code code;
    folder_ = fs::absolute(dataFolder.empty() ? fs::path(".") : dataFolder, code)
                  .lexically_normal()
                  .string();
    const HeaderStamp library = headerStampOf(reader.library).value_or(HeaderStamp{});
    reader_ =
        fmt::format("{} {} {} {}", reader.id, reader.version, library.bytes, library.changedNs);
    if (cacheFolder.empty()) return;
    cacheFile_ = cacheFolder / fmt::format("{:016x}{}", hashOf(folder_ + reader.id), kExtension);
    try {
        load();
    } catch (const std::exception&) {
        entries_.clear();  // of another version or damaged: it will be overwritten
    }
}

/// Everything is compared before it is used: checksum, version, folder and reader.
void HeaderCache::load() {
    const auto stamp = headerStampOf(cacheFile_);
    if (!stamp || stamp->bytes > kMostBytes) return;
    std::ifstream in(cacheFile_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t body = std::min(kChecksumLength, text.size());
    if (text.substr(0, body) != checksumOf(std::string_view(text).substr(body))) return;
    wire::Unpacker from(std::string_view(text).substr(body));
    if (from.number<std::uint32_t>() != kVersion || from.text() != folder_ ||
        from.text() != reader_) {
        return;
    }
    std::vector<DatasetInfo> common(from.count(sizeof(std::uint64_t)));
    for (DatasetInfo& description : common) {
        const std::string packed = from.text();
        wire::Unpacker inner(packed);
        description = wire::unpackBesidesTimes(inner);
    }
    for (std::size_t left = from.count(sizeof(std::uint64_t)); left > 0; --left) {
        const std::string name = from.text();
        Entry entry;
        entry.stamp = from.number<HeaderStamp>();
        entry.parts = from.number<HeaderStamp>();
        entry.description = common.at(from.number<std::uint64_t>());
        entry.description.times = wire::unpackTimes(from);
        entries_[name] = std::move(entry);
    }
}

std::optional<DatasetInfo> HeaderCache::find(const fs::path& file, const HeaderStamp& stamp) const {
    const auto found = entries_.find(file.filename().string());
    if (found == entries_.end() || found->second.stamp != stamp) return {};
    if (found->second.parts != stampOfParts(found->second.description)) return {};
    return found->second.description;
}

void HeaderCache::put(const fs::path& file, const HeaderStamp& stamp, DatasetInfo description) {
    const HeaderStamp parts = stampOfParts(description);
    entries_[file.filename().string()] = {stamp, parts, std::move(description)};
    changed_ = true;
}

void HeaderCache::save() const {
    if (!changed_ || cacheFile_.empty()) return;
    try {
        std::vector<std::string> common;
        wire::Packer files;
        std::uint64_t count = 0;
        for (const auto& [name, entry] : entries_) {
            if (headerStampOf(fs::path(folder_) / name) != entry.stamp) continue;
            wire::Packer rest;
            wire::packBesidesTimes(rest, entry.description);
            std::string shared = rest.take();
            const auto place = std::ranges::find(common, shared);
            const auto index = static_cast<std::uint64_t>(place - common.begin());
            if (place == common.end()) common.push_back(std::move(shared));
            files.text(name).number(entry.stamp).number(entry.parts).number(index);
            wire::packTimes(files, entry.description.times);
            ++count;
        }
        wire::Packer to;
        to.number(kVersion).text(folder_).text(reader_);
        to.number(static_cast<std::uint64_t>(common.size()));
        for (const std::string& description : common) to.text(description);
        to.number(count);
        const std::string body = to.take() + files.take();
        fs::create_directories(cacheFile_.parent_path());
        if (!fs::exists(cacheFile_)) prune(cacheFile_.parent_path());
        replaceFile(cacheFile_, checksumOf(body) + body);
    } catch (const Error&) {
    } catch (const fs::filesystem_error&) {
    }
}

}  // namespace neph
