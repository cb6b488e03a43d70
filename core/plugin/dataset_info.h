// dataset_info.h: everything about a data set, or one of its files, that is known without reading a
// field.
//
// A reader states it about one file, as if the file were a data set of its own; a series makes one
// of all its files. The same struct comes through the reader ABI, from process to process, out of
// the header cache and to the screen. It is validated where it enters, in plugin_file.cpp.
#pragma once
#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/utc_time.h"
#include "core/geo/map_grid.h"
#include "core/grid/species.h"

namespace neph {

/// What a variable means to the host; anything else is `other` and can still be read by name. The
/// values are those of NephRole.
enum class VariableRole : int {
    other,
    mixingRatio,               ///< of `species`, kg per kg of dry air
    dryAirDensity,             ///< kg/m³ at cell centres
    interfaceHeight,           ///< m above sea level, nz + 1 levels, increasing
    airPressure,               ///< Pa
    airTemperature,            ///< K
    effectiveRadius,           ///< of `species`, m
    numberConcentration,       ///< of `species`, per kg of dry air
    waterVapour,               ///< kg per kg of dry air
    xWind,                     ///< m/s along the grid's x, at cell centres
    yWind,                     ///< m/s along the grid's y, at cell centres
    upwardWind,                ///< m/s, at cell centres
    hygroscopicAerosolNumber,  ///< of aerosol that takes up water, per kg of dry air
    dustNumber                 ///< of mineral dust, per kg of dry air
};
inline constexpr int kVariableRoles = 14;

/// The scheme whose particle size distributions the hydrometeors follow. The values are those of
/// NephMicrophysics. docs/physics.md §7
enum class Microphysics : int { unknown, lin, wsm6, thompson, morrison };
inline constexpr int kMicrophysics = 5;

/// One variable of a data set.
struct VariableInfo {
    std::string name;          ///< as in the file, or as the reader names a derived variable
    std::string standardName;  ///< CF standard name, or empty
    std::string units;         ///< SI, of the values that `read` returns
    std::string description;
    VariableRole role = VariableRole::other;
    std::optional<Species> species;
    glm::ivec3 size{0};       ///< x, y, z; 1 where the variable lacks the axis
    std::string reason = {};  ///< why the reader gave it its role, one phrase; or empty
    bool operator==(const VariableInfo&) const = default;
};

/// One time of a data set, and where it is stored.
struct TimeInfo {
    std::string label;  ///< as the model writes it, for example 0001-01-01_01:00:00
    /// Since the first time of the series; of one file: on the clock that the files of a series
    /// share.
    double seconds = 0.0;
    std::filesystem::path file;  ///< filled in by the series
    int indexInFile = 0;
    std::optional<UtcTime> utc = {};  ///< where the data state a date
    /// How far the grid has moved over the ground since it lay where `map` has it, along x and y.
    glm::dvec2 gridOffsetM{0.0};
    bool operator==(const TimeInfo&) const = default;
};

/// Which domain of a nested run data are, and where in its parent, as their files number them.
struct NestNumbers {
    int number = 0;             ///< from 1; 0: not of a nested run
    int parent = 0;             ///< number of the domain that it lies in; 0: none
    glm::ivec2 cornerCells{0};  ///< of the parent, between its south-west corner and this one's
    int ratio = 0;              ///< cells along one of the parent; 0: unknown
    bool operator==(const NestNumbers&) const = default;
};

/// Everything about a data set or a file that is known without reading a field.
struct DatasetInfo {
    std::string reader;  ///< plugin id; filled in by the series
    std::string model;   ///< for example "WRF V4.2.2"
    std::string scheme;  ///< for example "Thompson (MP_PHYSICS 8)"; empty when unknown
    Microphysics microphysics = Microphysics::unknown;
    double cloudDropletsPerM3 = 0.0;  ///< prescribed by the run; 0 when unknown
    glm::ivec3 size{0};               ///< cells in x, y, z on the native grid
    glm::dvec2 spacingM{0.0};  ///< of the native cells; of the even cells made of them, with edges
    /// Faces of the native cells in x and y, metres from the south-west corner, where they are not
    /// even; empty otherwise.
    std::array<std::vector<double>, 2> edgesM;
    std::string domain;                        ///< files with different texts are never one series
    std::vector<std::filesystem::path> parts;  ///< other files that are read with this one
    MapGrid map;                               ///< where the grid lies on the earth
    std::string noPlace;  ///< why it has none, such as \"the run is idealised\"; or empty
    /// Rows along y that are stored as one, such as those of a compressed chunk: a handle keeps
    /// what it has read of them. 0 or 1: each row by itself.
    std::uint32_t rowsTogether = 0;
    NestNumbers nest;
    std::vector<TimeInfo> times;  ///< sorted by time; of one file: in its order, at least one
    std::vector<VariableInfo> variables;
    std::vector<std::string> notes;  ///< what was skipped or assumed, one sentence each
    std::map<std::string, std::string> attributes;  ///< global attributes worth showing, as text
    bool operator==(const DatasetInfo&) const = default;

    /// Size of the domain in x and y, metres.
    glm::dvec2 extentM() const;
    /// Whether the grid lies elsewhere on the ground at some of its times.
    bool moves() const;
    /// Position of face `face` along x (0) or y (1), metres; 0 to `size`.
    double edgeM(int axis, int face) const;

    /// The variable with a name, or with a role (and species); nullptr if there is none.
    const VariableInfo* find(std::string_view name) const;
    const VariableInfo* find(VariableRole role, std::optional<Species> species = {}) const;
};

}  // namespace neph
