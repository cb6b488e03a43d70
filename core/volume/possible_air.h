// possible_air.h: pressure, temperature and density must be those of air that is possible, in every
// reader's data.
//
// The limits are those of core/plugin/reader_abi.h.
#pragma once
#include <vector>

#include "core/dataset/dataset.h"
#include "core/volume/native_band.h"

namespace neph {

/// Throws Error if `variable` has such a role and one of its `values` in `box` is missing or
/// impossible. A density is often derived: the error then names the pressure, temperature or vapour
/// of that cell that explains it.
void requirePossibleAir(Dataset& dataset, int time, const VariableInfo& variable,
                        const CellBox& box, const Array3f& values);

/// Throws Error if the density of a cell is far from what air has at its height: a wrong unit of
/// pressure or of heights makes every value wrong and none impossible.
void requireAirOfHeight(Dataset& dataset, int time, const ColumnField& heights,
                        const ColumnField& density);

/// The value with its bytes in the opposite order.
float bytesSwapped(float value);

}  // namespace neph
