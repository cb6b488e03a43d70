// resample.h: from a model's native levels to a regular grid in metres, conserving the mass of
// every column.
//
// Within a native layer the content is taken as a straight line of height, its slope limited so
// that nothing overshoots or turns negative; the line is integrated exactly over each target layer.
// The horizontal grid stays as it is.
#pragma once
#include <span>

#include "core/dataset.h"
#include "core/progress.h"
#include "core/species.h"

namespace neph {

struct ResampleOptions {
    int levels = 0;       ///< number of target levels; 0 chooses them from the data
    int maxLevels = 256;  ///< bound on what is chosen
};

/// Heights of interfaces, metres, nz + 1 levels. Throws Error when they do not increase in every
/// column.
Array3f readInterfaceHeights(Dataset& dataset, int time, const Progress& progress = {});

/// Median depth of all layers, metres.
double medianLayerDepth(const Array3f& interfaceHeights);

/// The target grid of one time of a dataset: native x, y; from the lowest to the highest interface,
/// spacing no coarser than the median native layer unless `maxLevels` forbids. Chosen spacings and
/// borders are rounded outward to numbers that the times of a series share. Throws Error.
RegularGrid chooseGrid(Dataset& dataset, int time, const ResampleOptions& options);

/// Mass content of every hydrometeor of `dataset` at `time`. Negative and missing values are
/// clipped, counted and noted. Column mass is conserved to 1e-4 for every species. Throws Error or
/// Cancelled.
SpeciesVolume resample(Dataset& dataset, int time, const ResampleOptions& options = {},
                       const Progress& progress = {});

/// One column: content (kg/m³) of native layers between `interfacesM` (one more than layers,
/// increasing) onto target layers of `spacingM` from `bottomM` upward, added up into `target`. What
/// lies outside the target is lost.
void resampleColumn(std::span<const double> interfacesM, std::span<const double> content,
                    double bottomM, double spacingM, std::span<double> target);

}  // namespace neph
