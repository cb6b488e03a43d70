// native_band.h: native fields read in bands of rows, so that work on a large grid holds little of
// it at once.
//
// A band is a Box of whole columns. Indices of columns run x fastest within the band; levels count
// from the ground. Heights and density of models with flat levels may be profiles.
#pragma once
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/dataset/dataset.h"
#include "core/volume/repair.h"

namespace neph {

/// Values of one variable in the columns of a band. A profile (1 x 1 x n) holds for every column.
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
Box wholeBox(const DatasetInfo& info);

/// Cuts `box` into bands from south to north, each of a multiple of `coarsening` rows (but the
/// last) and of about a megabyte a field.
std::vector<Box> bandsOf(const Box& box, int coarsening);

/// The variable of a role. Throws Error where there is none or it does not lie on the grid;
/// `meaning` says what is missed.
const VariableInfo& requiredVariable(const Dataset& dataset, VariableRole role,
                                     std::string_view meaning);

/// Throws Error unless the variable has the cells of the grid, or is a profile of them where
/// `profiles` allows it.
void requireOnGrid(const Dataset& dataset, const VariableInfo& variable, bool profiles);

/// One variable in the columns of `band`; of variables on interfaces one level more than layers.
/// Throws Error or Cancelled, as the functions below do.
ColumnField readColumns(Dataset& dataset, const VariableInfo& variable, int time, const Box& band,
                        const Progress& progress = {});

/// Heights of interfaces, m. Throws Error unless they increase upward in every column.
ColumnField readHeights(Dataset& dataset, int time, const Box& band, const Progress& progress = {});

/// Density of dry air, kg/m³. Throws Error where it is not above zero.
ColumnField readDensity(Dataset& dataset, int time, const Box& band, const Progress& progress = {});

/// Mixing ratio, kg/kg, with what cannot be set to zero and counted in `repairs`.
Array3f readRatio(Dataset& dataset, const VariableInfo& variable, int time, const Box& band,
                  Repairs& repairs, const Progress& progress = {});

/// Called with a handle of the data set that no other thread uses meanwhile.
using BandWork = std::function<void(Dataset& dataset, std::size_t band, const Progress& progress)>;

/// Runs `work` for every band, on several threads where the data set gives further handles. Throws
/// what the work of the southernmost failing band threw, or Cancelled; `progress` is called on
/// this thread alone.
void overBands(Dataset& dataset, std::size_t bandCount, const BandWork& work,
               const Progress& progress = {});

}  // namespace neph
