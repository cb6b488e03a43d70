// ensemble_drawing.h: a map of an ensemble as an image, for window and files.
#pragma once
#include "core/image/map_image.h"
#include "core/volume/ensemble_maps.h"

namespace neph {

/// With axes, title and colour bar: from 0 to 1 for a probability, else to a round number. The map
/// is about `widthPx` wide.
MapImage drawEnsembleMap(const EnsembleDepths& depths, EnsembleMap map, double threshold,
                         int widthPx = 480);

}  // namespace neph
