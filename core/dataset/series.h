// series.h: from files and folders to the description of each file of the series in them: one for
// each domain.
//
// The first file chooses the reader by its content; the others are opened with that reader, several
// at once, or taken from the header cache. Named files must all be readable. A folder stands for
// what that reader reads in it: other files are left out and noted. Files of one nest in other
// places are one series, whose grid moves.
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
    std::vector<SeriesFile> files;      ///< at least one; all on one grid
    std::vector<std::string> notes;     ///< what was left out
    std::filesystem::path folder = {};  ///< that the user named; empty if a file was named itself
};

/// Describes the series that `named` files and folders contain, one for each grid of a domain, that
/// of the first file first; reads headers only. What was left out is noted there. The header cache
/// is kept under `cacheFolder`; there is none if that is empty. Throws Error or Cancelled.
std::vector<Series> describeSeries(std::span<const std::filesystem::path> named,
                                   const PluginHost& host, const std::filesystem::path& cacheFolder,
                                   const Progress& progress);

}  // namespace neph
