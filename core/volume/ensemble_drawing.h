// ensemble_drawing.h: a map of an ensemble as an image, for window and files.
#pragma once
#include "core/image/map_image.h"
#include "core/volume/ensemble_maps.h"

namespace neph {

/// With axes, title and colour bar: from 0 to 1 for a probability, else to a round number.
MapImage drawEnsembleMap(const EnsembleDepths& depths, EnsembleMap map, double threshold);

}  // namespace neph
