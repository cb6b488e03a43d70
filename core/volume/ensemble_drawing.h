// ensemble_drawing.h: a map of an ensemble as a plot, for window and files.
#pragma once
#include "core/plot/figure.h"
#include "core/volume/ensemble_maps.h"

namespace neph {

/// Colours go from 0 to 1 for a probability, else to a round number.
plot::Figure ensembleFigure(const EnsembleDepths& depths, EnsembleMap map, double threshold);

}  // namespace neph
