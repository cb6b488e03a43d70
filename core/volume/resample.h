// resample.h: from a model's native levels to a regular grid in metres, conserving the mass of
// every column, and of the domain where columns are averaged.
//
// The work goes band by band of native rows, so that little more is held than the result. Within a
// native layer the content is taken as a straight line of height, its slope limited so that nothing
// overshoots or turns negative; the line is integrated exactly over each target layer.
#pragma once
#include <optional>
#include <span>

#include "core/base/progress.h"
#include "core/dataset/dataset.h"
#include "core/grid/species.h"
#include "core/volume/radius_plan.h"
#include "core/volume/read_plan.h"

namespace neph {

struct ResampleOptions {
    std::optional<ReadPlan> plan{};  ///< none: everything at full resolution
    RadiusPlan radii{};              ///< which species become extinction, and how
};

/// Heights of interfaces, metres, nz + 1 levels. Throws Error when they do not increase in every
/// column.
Array3f readInterfaceHeights(Dataset& dataset, int time, const Progress& progress = {});

/// Median depth of all layers, metres.
double medianLayerDepth(const Array3f& interfaceHeights);

/// Mass content, or extinction where `radii` asks for it, of every hydrometeor of `dataset` at
/// `time`. Negative and missing values are clipped, counted and noted. The integral of every column
/// is conserved to 1e-4 for every species, that of the domain where columns are averaged. Reads on
/// several threads. Throws Error or Cancelled.
SpeciesVolume resample(Dataset& dataset, int time, const ResampleOptions& options = {},
                       const Progress& progress = {});

/// One column: content (kg/m³) of native layers between `interfacesM` (one more than layers,
/// increasing) onto target layers of `spacingM` from `bottomM` upward, added up into `target`. What
/// lies outside the target is lost.
void resampleColumn(std::span<const double> interfacesM, std::span<const double> content,
                    double bottomM, double spacingM, std::span<double> target);

}  // namespace neph
