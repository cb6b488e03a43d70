// resample.h: from a model's native levels to a regular grid in metres, conserving the mass of every column.
#pragma once
#include "core/dataset.h"
#include "core/progress.h"
#include "core/species.h"

namespace neph {

struct ResampleOptions {
    int levels = 0;        ///< number of target levels; 0 chooses them from the data
    int maxLevels = 256;   ///< bound on what is chosen
};

/// The target grid of one time of a dataset: native x, y; vertical spacing no coarser than the median native layer.
RegularGrid chooseGrid(Dataset& dataset, int time, const ResampleOptions& options);

/// Mass content of every hydrometeor of `dataset` at `time`. Negative and missing values are clipped, counted and noted.
/// Column mass is conserved to 1e-4 for every species. Throws Error or Cancelled.
SpeciesVolume resample(Dataset& dataset, int time, const ResampleOptions& options = {},
                       const Progress& progress = {});

}  // namespace neph
