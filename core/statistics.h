// statistics.h: what a forecaster asks of a model time before looking at it. Native grid, SI.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/dataset.h"
#include "core/progress.h"
#include "core/species.h"

namespace neph {

/// Where one hydrometeor is densest at one time.
struct SpeciesPeak {
    Species species = Species::cloud;
    std::string variable;
    float ratioKgPerKg = 0.0f;  ///< 0 where there is none
    glm::dvec3 positionM{0.0};  ///< centre of the cell; z above sea level
};

/// Layers of the native grid at one time, metres.
struct LayerSummary {
    double lowestM = 0.0, highestM = 0.0;  ///< interfaces above sea level
    double thinnestM = 0.0, medianM = 0.0, thickestM = 0.0;
};

struct TimeSummary {
    int time = 0;
    LayerSummary layers;
    std::vector<SpeciesPeak> peaks;  ///< one for each species of the dataset, in order of Species
    std::vector<std::string> notes;  ///< what would be clipped
};

/// Reads heights and mixing ratios of one time. Throws Error or Cancelled.
TimeSummary summarise(Dataset& dataset, int time, const Progress& progress = {});

}  // namespace neph
