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

class Dataset;

/// A nest at one time.
struct NestAt {
    int time = 0;               ///< of the nest's own series
    glm::ivec2 cornerCells{0};  ///< of the nest, between the south-west corners of it and the whole
};

/// A domain within another. core/dataset/nested_dataset.h
struct Nest {
    std::string name;                       ///< "d02", or that of its first file
    std::shared_ptr<Dataset> dataset;       ///< on its own, at its own times
    int ratio = 1;                          ///< cells along one of the outermost domain
    std::vector<std::optional<NestAt>> at;  ///< for each time of the outermost domain

    /// Its south-west corner in the world space of the outermost domain, metres.
    glm::dvec2 cornerM(const DatasetInfo& outermost, const NestAt& place) const {
        return glm::dvec2(place.cornerCells) * outermost.spacingM / static_cast<double>(ratio);
    }
    /// Whether it lies elsewhere in the outermost domain at some of its times.
    bool moves() const;
};

/// A series of model output. Readers are one implementation; tests use another that holds its data
/// in memory.
class Dataset {
  public:
    /// Opens files, or folders of files, that form one series, see core/dataset/series.h; the
    /// headers of long series are cached in the user's cache folder. Domains of a nested run are
    /// composed. Throws Error if no reader accepts them, a reader fails or they do not fit
    /// together, or Cancelled.
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

    /// The nests that are shown within these data, coarser ones first; all else is about the
    /// outermost domain.
    virtual std::span<const Nest> nests() const { return {}; }
    /// The unit of lengths that a look gives in cells: the finest domain's, at all times.
    double finestCellM() const;
    /// The files that a time is read from, those of nests included.
    std::vector<std::filesystem::path> filesAt(int time) const;

    /// The same series for another thread, opened cheaply; null if only one handle is possible.
    virtual std::unique_ptr<Dataset> anotherHandle() const { return nullptr; }

  protected:
    Dataset() = default;
    Dataset(const Dataset&) = default;
    Dataset& operator=(const Dataset&) = default;

    DatasetInfo info_;
};

}  // namespace neph
