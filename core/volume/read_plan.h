// read_plan.h: how much of a data set is read for a picture: where, and how finely, so that it fits
// into memory.
//
// A plan is made before any mixing ratio is read. What is coarsened is averaged, not skipped: every
// block of `coarsening` x `coarsening` columns becomes one column with their mean content, so that
// the mass of the domain stays the same.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>

#include "core/dataset/dataset.h"
#include "core/grid/grid.h"

namespace neph {

/// What one time's volume may take, in bytes. Without bounds unless told.
struct MemoryBudget {
    std::uint64_t machine = std::numeric_limits<std::uint64_t>::max();  ///< fields of the process
    std::uint64_t gpu = std::numeric_limits<std::uint64_t>::max();      ///< fields and medium
    bool operator==(const MemoryBudget&) const = default;
};

/// What a renderer that computes on the CPU may take: its bound is time, not memory.
/// docs/measurements.md
inline constexpr std::uint64_t kSoftwareGpuBytes = 128U << 20U;

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

/// The finest plan for `region` (everything when not given) at `time` that fits `budget`, or the
/// coarsest there is. Cells that the region touches are read whole. The levels are spaced by the
/// median native layer, rounded so that the times of a series share them. Reads the lowest and the
/// highest interface and some rows of heights. Throws Error where the region holds no cell.
ReadPlan planRead(Dataset& dataset, int time, const std::optional<Region>& region = {},
                  const MemoryBudget& budget = {}, const Progress& progress = {});

/// One or two sentences for the screen and for `info`, for example "Every 2 x 2 columns are
/// averaged to one of 2 km: all would take 3.1 GiB, not 0.8 GiB." Empty for everything at full
/// resolution.
std::string describe(const ReadPlan& plan, const DatasetInfo& info);

}  // namespace neph
