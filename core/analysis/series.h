// series.h: how a run goes on: what is largest, highest and heaviest at each of its times.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/dataset/dataset.h"

namespace neph {

/// A largest value and the centre of its cell, metres; z above sea level.
struct Extreme {
    double value = 0.0;
    glm::dvec3 positionM{0.0};
};

/// One time of a run. Cloud and precipitation as core/volume/statistics.h counts them.
struct SeriesPoint {
    int time = 0;
    double seconds = 0.0;  ///< since the first time
    /// Largest mixing ratio of each species, g/kg; none where this time lacks it.
    std::array<std::optional<Extreme>, kSpeciesCount> mostGPerKg;
    std::optional<Extreme> updraftMPerS;
    std::optional<Extreme> downdraftMPerS;  ///< the smallest
    std::optional<Extreme> reflectivityDbz;
    /// Mass of each species in the domain, kg; none without the density of air.
    std::array<std::optional<double>, kSpeciesCount> massKg;
    std::optional<double> stormTopM;  ///< upper side of the highest cell with cloud
    std::optional<double> baseM;      ///< kLowShare of all cloudy columns have a base up to here
    double cover = 0.0;               ///< share of the domain's area under cloud
};

/// Reads one time in bands of rows, a few of them at once. Throws Error or Cancelled.
SeriesPoint readSeriesPoint(Dataset& dataset, int time, const Progress& progress = {});

}  // namespace neph
