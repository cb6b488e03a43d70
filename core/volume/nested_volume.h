// nested_volume.h: the volume of a data set and its nests, each where it is the finest.
//
// The grid is that of the outermost domain's metres: its columns are whole numbers of lattice cells
// (compose_domains.h), as few as the memory budget allows and no fewer than the finest nest has. A
// data set without nests is read as it is.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/dataset/dataset.h"
#include "core/grid/boxes.h"
#include "core/volume/compose_domains.h"
#include "core/volume/radius_plan.h"
#include "core/volume/read_plan.h"

namespace neph {

/// What is read of one domain.
struct DomainPlan {
    std::string name;  ///< empty for the outermost domain
    Dataset* dataset = nullptr;
    int time = 0;                      ///< of its own series
    ReadPlan plan{};                   ///< of its own cells, on the levels of the result
    LatticeGrid at{};                  ///< of plan.grid
    std::optional<NestEdges> edges{};  ///< of a nest
};

/// How a time is read.
struct NestedPlan {
    ReadPlan shown;  ///< the result: `even` and the region are the outermost domain's
    LatticeGrid at;  ///< of shown.grid
    std::vector<DomainPlan> domains;  ///< the outermost first; one where no nest is shown
    std::vector<std::string> notes;   ///< nests that this time lacks
};

/// As planRead, with the nests that lie in `region` at `time`. Domains with finer cells than the
/// result are read in blocks that divide its cells, so that these are the means of what lies in
/// them; only where the machine's memory does not suffice are blocks spread over neighbours.
/// Expected memory is that of the result and of the largest domain, which are held at once. The
/// plan refers to `dataset`.
/// `levels` as for planRead, of all domains.
NestedPlan planNested(Dataset& dataset, int time, const std::optional<BoxM>& region = {},
                      const MemoryBudget& budget = {}, const Progress& progress = {},
                      const std::optional<NativeLevels>& levels = {});

/// The grid of the same, and its memory.
ReadPlan planShown(Dataset& dataset, int time, const std::optional<BoxM>& region = {},
                   const MemoryBudget& budget = {}, const Progress& progress = {},
                   const std::optional<NativeLevels>& levels = {});

/// As resample, with the nests of the plan; where a domain lacks what a species' size needs, that
/// species is held as mass in all of them. Throws Error or Cancelled.
SpeciesVolume readNested(Dataset& dataset, int time, const NestedPlan& plan,
                         const RadiusPlan& radii, const Progress& progress = {});

}  // namespace neph
