// series.h: from files and folders to the description of each file of one series.
//
// The first file chooses the reader by its content; the others are opened with that reader, several
// at once, or taken from the header cache. Named files must all be readable. A folder stands for
// the series in it: files that do not belong to it are left out and noted.
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

/// One file of a series with its description.
struct SeriesFile {
    std::filesystem::path path;  ///< a file, or a folder that a reader accepts as a whole
    DatasetInfo description;
};

/// The files of a series, and the reader that they have in common.
struct Series {
    std::shared_ptr<const ReaderPlugin> reader;
    std::vector<SeriesFile> files;   ///< at least one; all on one grid
    std::vector<std::string> notes;  ///< what was left out
};

/// Describes the series that `named` files and folders contain; reads headers only. The header
/// cache is kept under `cacheFolder`; there is none if that is empty. Throws Error or Cancelled.
Series describeSeries(std::span<const std::filesystem::path> named, const PluginHost& host,
                      const std::filesystem::path& cacheFolder, const Progress& progress);

}  // namespace neph
