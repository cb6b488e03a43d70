// ensemble_maps.h: what an ensemble says of each column at one time: the probability that the
// vertical optical depth exceeds a threshold, and mean and spread of that depth.
//
// The depths are those that images are drawn with: the extinction of the look, on the grid that the
// volume is shown on. Columns are x fastest, from south to north.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/dataset/ensemble.h"
#include "core/geo/map_grid.h"
#include "core/look/look.h"
#include "core/volume/held_volume.h"

namespace neph {

/// Optical depths of all members, from which any map follows at once.
struct EnsembleDepths {
    std::string timeLabel;
    std::optional<UtcTime> utc{};
    RegularGrid grid;
    MapGrid map{};                       ///< of the position {0, 0} of the grid where it lies now
    std::vector<std::string> members;    ///< that have the time
    std::vector<std::string> without;    ///< that lack it
    std::string scale;                   ///< "to scale", or why not: scaleText()
    std::vector<std::vector<float>> of;  ///< optical depth of each column, for each of `members`

    std::size_t columns() const {
        return static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y);
    }
    /// Centre of a column, metres of the grid.
    glm::dvec2 centreM(std::size_t column) const;
    /// The place of each column; empty where the data state none, NaN beyond the map's edge.
    std::vector<GeoPoint> places() const;
};

/// The maps that can be made.
enum class EnsembleMap : int { probability, mean, spread };

/// One value for each column. `threshold` is of the probability: the share of the members whose
/// optical depth is above it, 0 to 1. The spread is the standard deviation over the members with
/// n - 1, as [Fortin14]; NaN for a single member.
std::vector<float> mapOf(const EnsembleDepths& depths, EnsembleMap map, double threshold);

/// "Probability of optical depth > 1", for titles.
std::string titleOf(EnsembleMap map, double threshold);

/// The volumes of members at the time, by index, that are in memory; nullptr for others, or none.
using KnownVolumes = std::vector<std::shared_ptr<const SpeciesVolume>>;

/// Reads the members one after the other. `request` is as for an image; its member is ignored.
/// Throws Error if members lie apart, or Cancelled.
EnsembleDepths readEnsembleDepths(Ensemble& ensemble, int time, VolumeRequest request,
                                  const Look& look, const KnownVolumes& known = {},
                                  const Progress& progress = {});

}  // namespace neph
