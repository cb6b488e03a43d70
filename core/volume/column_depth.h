// column_depth.h: the vertical optical depth of every column of a volume.
#pragma once
#include <vector>

#include "core/grid/species.h"
#include "core/look/medium.h"

namespace neph {

/// Extinction as the image is drawn with it, without detail noise, integrated over all levels; x
/// fastest, size grid.size.x * grid.size.y.
std::vector<float> columnDepths(const SpeciesVolume& volume, const MediumPlan& plan);

}  // namespace neph
