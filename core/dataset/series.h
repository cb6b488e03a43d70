// series.h: from files and folders to what a reader says of each file of one series.
//
// The first file chooses the reader by its content; the others are opened with that reader, several
// at once, or taken from the header cache. Named files must all be readable. A folder stands for
// the series in it: what does not belong to it is left out and noted.
#pragma once
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/plugin/plugin_host.h"
#include "core/plugin/reader_file.h"

namespace neph {

struct SeriesFile {
    std::filesystem::path path;  ///< a file, or a folder that a reader takes as a whole
    FileDescription description;
};

struct Series {
    std::shared_ptr<const ReaderPlugin> reader;
    std::vector<SeriesFile> files;   ///< at least one; all on one grid
    std::vector<std::string> notes;  ///< what was left out
};

/// Describes the series that `named` files and folders hold; reads headers alone. Entries of the
/// header cache are kept under `cacheFolder`; empty: none. Throws Error or Cancelled.
Series describeSeries(std::span<const std::filesystem::path> named, const PluginHost& host,
                      const std::filesystem::path& cacheFolder, const Progress& progress);

}  // namespace neph
