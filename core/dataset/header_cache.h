// header_cache.h: remembers file descriptions, so that a long series need not be opened file by
// file again.
//
// An entry is valid only while path, size, modification time (to the nanosecond), the reader and
// its library are unchanged, and so are the other files that the data set is read from. One cache
// file holds the entries of one data folder; a damaged one counts as empty.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/plugin/plugin_host.h"
#include "core/plugin/reader_file.h"

namespace neph {

/// Size and modification time, which show whether a file has changed.
struct HeaderStamp {
    std::uintmax_t bytes = 0;
    std::int64_t changedNs = 0;
    bool operator==(const HeaderStamp&) const = default;
};

/// Empty for anything but a regular file.
std::optional<HeaderStamp> headerStampOf(const std::filesystem::path& file);

/// The cached descriptions of the files in one folder, for one reader.
class HeaderCache {
  public:
    /// The entries of the files in `dataFolder`, stored in a file of `cacheFolder`; nothing is
    /// stored if that is empty.
    HeaderCache(std::filesystem::path cacheFolder, const std::filesystem::path& dataFolder,
                const ReaderName& reader);

    /// Folder of the header cache below the user's cache folder.
    static std::filesystem::path standardFolder();

    std::optional<DatasetInfo> find(const std::filesystem::path& file,
                                    const HeaderStamp& stamp) const;
    void put(const std::filesystem::path& file, const HeaderStamp& stamp, DatasetInfo description);

    /// Writes what `put` has added, without entries whose files have changed or gone, and removes
    /// the oldest cache files if there are too many. Errors are ignored: the cache is only a
    /// shortcut.
    void save() const;

  private:
    struct Entry {
        HeaderStamp stamp;
        HeaderStamp parts;  ///< of all parts together: their bytes, and the last change
        DatasetInfo description;
    };
    void load();

    std::filesystem::path cacheFile_;
    std::string folder_;                    ///< data folder, absolute
    std::string reader_;                    ///< id, version and stamp of its library
    std::map<std::string, Entry> entries_;  ///< by file name
    bool changed_ = false;
};

}  // namespace neph
