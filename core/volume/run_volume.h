// run_volume.h: the volume of one run, of a member of an ensemble on the grid that all members
// share, or the mean of the members.
//
// The mean is that of what volumes hold: mass content, or extinction where the model sizes the
// particles. So its optical depth along any line is the mean of the members', and its effective
// radius that of the particles of all members together.
#pragma once
#include "core/dataset/ensemble.h"
#include "core/grid/species.h"
#include "core/volume/held_volume.h"
#include "core/volume/lowest_air.h"
#include "core/volume/read_plan.h"

namespace neph {

/// A volume, and how it was read.
struct RunVolume {
    SpeciesVolume volume;
    ReadPlan plan;
    glm::dvec2 domainHeightsM{0.0};  ///< lowest and highest level of the whole domain
};

/// What `request` asks for: of a single run, or of the ensemble's member or mean. Throws Error,
/// also where the member lacks the time, or Cancelled.
RunVolume readRuns(Dataset& dataset, int time, const VolumeRequest& request,
                   const Progress& progress = {});

/// A member at a time of the ensemble, on the shared grid. Throws as readRuns.
RunVolume readMember(Ensemble& ensemble, int member, int time, const VolumeRequest& request,
                     const Progress& progress = {});

/// The levels that all members share at a time: the layer depth of the first member that has it,
/// from the lowest interface of all to the highest. They are read once for each time.
NativeLevels sharedLevels(Ensemble& ensemble, int time, const Progress& progress = {});

/// The air of a run, a member, or the means of those members that state it.
LowestAir readLowestAirOf(Dataset& dataset, int time, int member, const Progress& progress = {});

/// Throws Error where a member's volume is on another grid than `expected`, that of the first, as
/// where grids move apart.
void requireSameGrid(const RegularGrid& grid, const RegularGrid& expected,
                     const std::string& member);

/// The mean of volumes on one grid, of which only the sum is held.
class MeanVolume {
  public:
    /// A species that a volume lacks counts as zero. Throws Error that names the `member` if its
    /// grid is another, or it holds a species in the other way.
    void add(SpeciesVolume volume, const std::string& member);
    int count() const { return count_; }
    /// The mean so far, with the label of the first, without notes. Nothing is left.
    SpeciesVolume take();

  private:
    SpeciesVolume mean_;
    int count_ = 0;
};

}  // namespace neph
