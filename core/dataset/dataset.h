// dataset.h: one series of model output, opened cheaply and read lazily through a reader plugin.
//
// Opening reads only metadata. `read` returns plain data in SI units that outlive the reader. A
// Dataset may be used by one thread at a time.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/grid/boxes.h"
#include "core/grid/grid.h"
#include "core/plugin/dataset_info.h"
#include "core/plugin/plugin_host.h"

namespace neph {

/// A series of model output. Readers are one implementation; tests use another that holds its data
/// in memory.
class Dataset {
  public:
    /// Opens files, or folders of files, that form one series, see core/dataset/series.h; the
    /// headers of long series are cached in the user's cache folder. Throws Error if no reader
    /// accepts them or a reader fails, or Cancelled.
    static std::shared_ptr<Dataset> open(std::span<const std::filesystem::path> files,
                                         const PluginHost& host, const Progress& progress = {});
    /// The same with the header cache under `cacheFolder`; no cache if that is empty.
    static std::shared_ptr<Dataset> open(std::span<const std::filesystem::path> files,
                                         const PluginHost& host,
                                         const std::filesystem::path& cacheFolder,
                                         const Progress& progress);
    virtual ~Dataset() = default;

    const DatasetInfo& info() const { return info_; }

    /// Whether one time has a variable: in a series, some files may lack it.
    virtual bool has(std::string_view variable, int time) const;
    /// `info` without the variables that one time lacks.
    DatasetInfo infoAt(int time) const;

    /// Values of one variable at one time, in the units that `info` gives. `box` defaults to
    /// everything. Throws Error (unknown variable, failed read) or Cancelled.
    virtual Array3f read(std::string_view variable, int time, std::optional<CellBox> box = {},
                         const Progress& progress = {}) = 0;

    /// The same series for another thread, opened cheaply; null if only one handle is possible.
    virtual std::unique_ptr<Dataset> anotherHandle() const { return nullptr; }

  protected:
    Dataset() = default;
    Dataset(const Dataset&) = default;
    Dataset& operator=(const Dataset&) = default;

    DatasetInfo info_;
};

}  // namespace neph
