// native_band.h: native fields read in bands of rows, so that little of a large grid is in memory
// at once.
//
// A band is a Box of whole columns. Column indices run x fastest within the band; levels count from
// the ground. Heights and density of models with flat levels may be profiles.
#pragma once
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/dataset/dataset.h"
#include "core/grid/boxes.h"
#include "core/volume/repair.h"

namespace neph {

/// Values of one variable in the columns of a band. A profile (1 x 1 x n) applies to every column.
struct ColumnField {
    Array3f values;
    bool profile = false;

    std::size_t columnStride() const { return profile ? 0 : 1; }
    std::size_t levelStride() const { return values.index(0, 0, 1); }
    float at(std::size_t column, std::size_t level) const {
        return values.values[column * columnStride() + level * levelStride()];
    }
};

/// All native columns of the data set.
CellBox wholeBox(const DatasetInfo& info);

/// Whether cells differ in width along x or y.
bool hasUnevenCells(const DatasetInfo& info);

/// Cuts `box` into bands from south to north, each of a multiple of `coarsening` rows (except the
/// last) and about a megabyte per field.
std::vector<CellBox> bandsOf(const CellBox& box, int coarsening);

/// The variable with a role. Throws Error if there is none or it does not lie on the grid;
/// `meaning` names it in the message.
const VariableInfo& requiredVariable(const Dataset& dataset, VariableRole role,
                                     std::string_view meaning);

/// One sentence for each hydrometeor of the series that one time lacks.
std::vector<std::string> absences(const Dataset& dataset, int time);

/// Throws Error unless the variable has the cells of the grid, or is a vertical profile where
/// `profiles` allows it.
void requireOnGrid(const Dataset& dataset, const VariableInfo& variable, bool profiles);

/// One variable in the columns of `band`; variables on interfaces have one level more than there
/// are layers. Throws Error if pressure, temperature or density is not that of possible air
/// (core/plugin/reader_abi.h), or Cancelled, as the functions below do. For a density that is not,
/// the error names the pressure or temperature of that cell that explains it.
ColumnField readColumns(Dataset& dataset, const VariableInfo& variable, int time,
                        const CellBox& band, const Progress& progress = {});

/// Heights of interfaces, m. Throws Error unless they increase with height in every column.
ColumnField readHeights(Dataset& dataset, int time, const CellBox& band,
                        const Progress& progress = {});

/// Density of dry air, kg/m³.
ColumnField readDensity(Dataset& dataset, int time, const CellBox& band,
                        const Progress& progress = {});

/// Mixing ratio, kg/kg; impossible values are set to zero and counted in `repairs`, from row
/// `countedFrom` of the band on.
Array3f readRatio(Dataset& dataset, const VariableInfo& variable, int time, const CellBox& band,
                  Repairs& repairs, const Progress& progress = {}, int countedFrom = 0);

/// Called with a handle of the data set that only reads for one thread at a time.
using BandWork = std::function<void(Dataset& dataset, std::size_t band, const Progress& progress)>;

/// Runs `work` for every band, on several threads if the data set provides further handles. Throws
/// what the work of the first failing run of bands, from the south, threw, or Cancelled; `progress`
/// is called on the calling thread only.
void overBands(Dataset& dataset, std::size_t bandCount, const BandWork& work,
               const Progress& progress = {});

}  // namespace neph
