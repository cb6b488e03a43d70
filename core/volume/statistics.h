// statistics.h: what a forecaster wants to know about a model time before rendering it. Native
// grid, SI.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/dataset/dataset.h"
#include "core/grid/species.h"
#include "core/volume/lowest_air.h"

namespace neph {

/// A cell counts as cloud, or as precipitation, from this mixing ratio: of cloud water and ice
/// together, or of rain, snow, graupel and hail together. A choice that is common in studies of
/// shallow cumulus: low enough for wisps, high enough to ignore numerical noise.
inline constexpr double kCloudRatioGPerKg = 0.01;
inline constexpr float kCloudRatioKgPerKg = 1e-5f;

/// The heaviest column.
struct ColumnPeak {
    double massKgPerM2 = 0.0;   ///< 0 where there is none
    glm::dvec2 positionM{0.0};  ///< its centre
};

/// Where one hydrometeor is densest at one time.
struct SpeciesPeak {
    Species species = Species::cloud;
    std::string variable;       ///< empty where this time lacks the species and others have it
    float ratioKgPerKg = 0.0f;  ///< 0 where there is none
    glm::dvec3 positionM{0.0};  ///< centre of the cell; z above sea level
    ColumnPeak column;
};

/// Layers of the native grid at one time, metres.
struct LayerSummary {
    double lowestM = 0.0, highestM = 0.0;  ///< interfaces above sea level
    double thinnestM = 0.0, medianM = 0.0, thickestM = 0.0;
};

/// From the lower side of the lowest cell to the upper side of the highest, above sea level.
struct HeightRange {
    double baseM = 0.0, topM = 0.0;
};

/// Heights of the lowest cloudy cells of columns, above sea level: one cell of fog makes the lowest
/// cell the ground, but moves none of these.
struct CloudBases {
    double lowM = 0.0;     ///< kLowShare of all cloudy columns have a base up to here
    double middleM = 0.0;  ///< half of them
    /// The median over the main updraft: the cloudy columns whose strongest upward wind is at least
    /// half the strongest of all. Without wind, those with at least half the most condensate.
    double updraftM = 0.0;
    std::string updraftVariable;  ///< the wind; empty without
    static constexpr double kLowShare = 0.05;
};

/// What `nephoscope info` reports about one time.
struct TimeSummary {
    int time = 0;
    LayerSummary layers;
    std::vector<SpeciesPeak> peaks;  ///< one for each species of the dataset, in order of Species
    bool hasColumns = false;         ///< false if the density of air is unknown
    ColumnPeak condensate;           ///< of all species together
    std::optional<HeightRange> cloud, precipitation;
    std::optional<CloudBases> bases;  ///< where there is cloud
    std::vector<std::string> notes;   ///< what resampling would clip
    LowestAir lowestAir;
};

/// Reads heights, density and mixing ratios of one time, in bands of rows, so that little is in
/// memory at once. Throws Error or Cancelled.
TimeSummary summarise(Dataset& dataset, int time, const Progress& progress = {});

}  // namespace neph
