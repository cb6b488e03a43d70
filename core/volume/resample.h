// resample.h: from a model's native levels to a regular grid in metres, conserving the mass of
// every column, and of the domain where columns are averaged.
//
// The work proceeds in bands of native rows, so that little more than the result is in memory.
// Within a native layer the content is linear in height, with its slope limited so that nothing
// overshoots or turns negative; it is integrated exactly over each target layer.
#pragma once
#include <optional>
#include <span>

#include "core/base/progress.h"
#include "core/dataset/dataset.h"
#include "core/grid/species.h"
#include "core/volume/radius_plan.h"
#include "core/volume/read_plan.h"

namespace neph {

/// Options of resample(); the defaults read everything as mass.
struct ResampleOptions {
    std::optional<ReadPlan> plan{};  ///< empty: everything at full resolution
    RadiusPlan radii{};              ///< which species become extinction, and how
};

/// Heights of interfaces, metres, nz + 1 levels. Throws Error unless they increase in every column.
Array3f readInterfaceHeights(Dataset& dataset, int time, const Progress& progress = {});

/// Median depth of all layers, metres.
double medianLayerDepth(const Array3f& interfaceHeights);

/// Mass content, or extinction where `radii` requires it, of every hydrometeor of `dataset` at
/// `time`. Negative and missing values are clipped, counted and noted. The integral of every column
/// is conserved to 1e-4 for every species; where columns are averaged, that of the domain. Reads on
/// several threads. Throws Error or Cancelled.
SpeciesVolume resample(Dataset& dataset, int time, const ResampleOptions& options = {},
                       const Progress& progress = {});

/// Remaps one column: adds content (kg/m³) of native layers between `interfacesM` (one more than
/// layers, increasing) to target layers of `spacingM` from `bottomM` upward. Content outside the
/// target is lost.
void resampleColumn(std::span<const double> interfacesM, std::span<const double> content,
                    double bottomM, double spacingM, std::span<double> target);

}  // namespace neph
