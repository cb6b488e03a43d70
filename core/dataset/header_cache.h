// header_cache.h: what readers said of files before, so that a long series need not be opened file
// by file again.
//
// An entry counts only while path, size, time of change (to the nanosecond), the reader and its
// library are what they were. One cache file holds the entries of one folder of data; whatever is
// odd about it, it counts as empty.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/plugin/plugin_host.h"
#include "core/plugin/reader_file.h"

namespace neph {

/// By which a file is known to be unchanged.
struct HeaderStamp {
    std::uintmax_t bytes = 0;
    std::int64_t changedNs = 0;
    bool operator==(const HeaderStamp&) const = default;
};

/// None for what is no regular file.
std::optional<HeaderStamp> headerStampOf(const std::filesystem::path& file);

class HeaderCache {
  public:
    /// Entries of the files in `dataFolder`, kept in a file of `cacheFolder`; empty: nowhere.
    HeaderCache(std::filesystem::path cacheFolder, const std::filesystem::path& dataFolder,
                const ReaderName& reader);

    /// The user's own cache.
    static std::filesystem::path standardFolder();

    std::optional<FileDescription> find(const std::filesystem::path& file,
                                        const HeaderStamp& stamp) const;
    void put(const std::filesystem::path& file, const HeaderStamp& stamp,
             FileDescription description);

    /// Writes what `put` has added, without entries whose files have changed or gone, and removes
    /// the cache files used longest ago where there are too many. Faults are no loss and silent.
    void save() const;

  private:
    struct Entry {
        HeaderStamp stamp;
        FileDescription description;
    };
    void load();

    std::filesystem::path cacheFile_;
    std::string folder_;                    ///< of the data, absolute
    std::string reader_;                    ///< id, version and stamp of its library
    std::map<std::string, Entry> entries_;  ///< by the name of the file
    bool changed_ = false;
};

}  // namespace neph
