// read_plan.h: how much of a data set is read for a picture: where, and how finely, so that it fits
// into memory.
//
// A plan is made before any field is read. What is coarsened is averaged, not skipped: every block
// of `coarsening` x `coarsening` columns becomes one column with their mean content, so that the
// mass of the domain stays the same.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "core/dataset.h"
#include "core/grid.h"

namespace neph {

/// What one time's volume may take, in bytes.
struct MemoryBudget {
    std::uint64_t machine;  ///< of the process: the fields of a SpeciesVolume
    std::uint64_t gpu;      ///< of the renderer: fields and medium
};

/// Part of the domain, metres from its south-west corner; z above sea level.
struct Region {
    glm::dvec3 lowerM{0.0};
    glm::dvec3 upperM{0.0};
    bool operator==(const Region&) const = default;
};

struct ReadPlan {
    Box box;             ///< native columns that are read, all levels
    int coarsening = 1;  ///< native columns along each edge of a block
    RegularGrid grid;    ///< what comes of it; levels cover the region asked for
    std::uint64_t machineBytes = 0, gpuBytes = 0;  ///< what it is expected to take
    bool operator==(const ReadPlan&) const = default;
};

/// The finest plan for `region` (everything when not given) at `time` that fits `budget`. Reads
/// the heights of some columns. Throws Error where the region holds no cell.
ReadPlan planRead(Dataset& dataset, int time, const std::optional<Region>& region,
                  const MemoryBudget& budget, const Progress& progress = {});

/// One sentence for the screen and for `info`, for example "Every 2 x 2 columns are averaged: the
/// whole domain at 1 km would take 3.1 GiB of 1.0 GiB." Empty for everything at full resolution.
std::string describe(const ReadPlan& plan, const DatasetInfo& info);

}  // namespace neph
