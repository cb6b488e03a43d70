// dataset.h: one series of model output, opened cheaply and read lazily through a reader plugin.
//
// Opening reads only metadata. `read` returns plain data in SI units that outlive the reader. A
// Dataset may be used by one thread at a time.
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/grid/grid.h"
#include "core/grid/species.h"
#include "core/plugin/plugin_host.h"

namespace neph {

/// What a variable means to the host; anything else is `other` and can still be read by name.
enum class VariableRole : int {
    other,
    mixingRatio,         ///< of `species`, kg per kg of dry air
    dryAirDensity,       ///< kg/m³ at cell centres
    interfaceHeight,     ///< m above sea level, nz + 1 levels, increasing
    airPressure,         ///< Pa
    airTemperature,      ///< K
    effectiveRadius,     ///< of `species`, m
    numberConcentration  ///< of `species`, per kg of dry air
};

/// The scheme whose particle size distributions the hydrometeors follow. docs/physics.md §7
enum class Microphysics : int { unknown, lin, wsm6, thompson, morrison };

/// One variable of a data set.
struct VariableInfo {
    std::string name;          ///< as in the file, or as the reader names a derived variable
    std::string standardName;  ///< CF standard name, or empty
    std::string units;         ///< SI, of the values that `read` returns
    std::string description;
    VariableRole role = VariableRole::other;
    std::optional<Species> species;
    glm::ivec3 size{0};  ///< x, y, z; 1 where the variable lacks the axis
    bool operator==(const VariableInfo&) const = default;
};

/// One time of a data set, and where it is stored.
struct TimeInfo {
    std::string label;     ///< as the model writes it, for example 0001-01-01_01:00:00
    double seconds = 0.0;  ///< since the first time of the series
    std::filesystem::path file;
    int indexInFile = 0;
};

/// Everything about a data set that is known without reading a field.
struct DatasetInfo {
    std::string reader;  ///< plugin id
    std::string model;   ///< for example "WRF V4.2.2"
    std::string scheme;  ///< for example "Thompson (MP_PHYSICS 8)"; empty when unknown
    Microphysics microphysics = Microphysics::unknown;
    double cloudDropletsPerM3 = 0.0;  ///< prescribed by the run; 0 when unknown
    glm::ivec3 size{0};               ///< cells in x, y, z on the native grid
    glm::dvec2 spacingM{0.0};
    std::vector<TimeInfo> times;  ///< sorted by time
    std::vector<VariableInfo> variables;
    std::vector<std::string> notes;  ///< what was skipped or assumed, one sentence each
    std::map<std::string, std::string> attributes;  ///< global attributes worth showing, as text

    /// The variable with a name, or with a role (and species); nullptr if there is none.
    const VariableInfo* find(std::string_view name) const;
    const VariableInfo* find(VariableRole role, std::optional<Species> species = {}) const;
};

/// Half-open box of native cells.
struct Box {
    glm::ivec3 lower{0};
    glm::ivec3 upper{0};
    glm::ivec3 size() const { return upper - lower; }
    bool operator==(const Box&) const = default;
};

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

    /// Values of one variable at one time, in the units that `info` gives. `box` defaults to
    /// everything. Throws Error (unknown variable, failed read) or Cancelled.
    virtual Array3f read(std::string_view variable, int time, std::optional<Box> box = {},
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
