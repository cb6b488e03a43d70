// read_plan.h: which part of a data set is read, and how finely, so that it fits into memory.
//
// A plan is made before any mixing ratio is read. Coarsening averages and never skips: every block
// of `coarsening` x `coarsening` columns becomes one column with their mean content, so that the
// mass of the domain is conserved. Where native cells differ in width, the columns that are
// averaged are even ones over the same domain, of the spacing that the reader states.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>

#include "core/dataset/dataset.h"
#include "core/dataset/native_levels.h"
#include "core/grid/boxes.h"
#include "core/grid/grid.h"

namespace neph {

/// Memory that the volume of one time may use, in bytes. Unlimited by default.
struct MemoryBudget {
    std::uint64_t machine = std::numeric_limits<std::uint64_t>::max();  ///< fields of the process
    std::uint64_t gpu = std::numeric_limits<std::uint64_t>::max();      ///< fields and medium
    bool operator==(const MemoryBudget&) const = default;
};

/// GPU budget of a renderer that runs on the CPU: its limit is time, not memory.
/// docs/measurements.md
inline constexpr std::uint64_t kSoftwareGpuBytes = 128U << 20U;

/// What to read, and the grid that results.
struct ReadPlan {
    CellBox box;         ///< native columns that are read, all levels
    CellBox even;        ///< the even columns that they give; the same where native ones are even
    int coarsening = 1;  ///< even columns along each edge of a block; of nests, the finest's
    RegularGrid grid;    ///< resulting grid; its levels cover the requested region
    std::uint64_t machineBytes = 0, gpuBytes = 0;  ///< expected memory
    std::string nested;  ///< of a nested run, what is composed and how finely; empty otherwise
    bool operator==(const ReadPlan&) const = default;
};

/// The heights that decide the levels at `time`: reads the lowest and the highest interface and
/// some rows in between. Throws Error or Cancelled.
NativeLevels readLevels(Dataset& dataset, int time, const Progress& progress = {});

/// The finest plan for `region` (default: everything) at `time` that fits `budget`, or the coarsest
/// possible. (Even) cells that the region touches are read whole. The level spacing is the median
/// native layer depth, rounded so that the times of a series share it. Reads the lowest and the
/// highest interface and some rows of heights, unless `levels` are given: runs that are to share a
/// grid have those in common. Throws Error if the region contains no cell.
ReadPlan planRead(Dataset& dataset, int time, const std::optional<BoxM>& region = {},
                  const MemoryBudget& budget = {}, const Progress& progress = {},
                  const std::optional<NativeLevels>& levels = {});

/// The same plan with blocks of `coarsening` x `coarsening` even columns.
ReadPlan coarsened(ReadPlan plan, int coarsening, const DatasetInfo& info);

/// Sets the expected memory of a grid with `species` fields.
void countBytes(std::uint64_t species, ReadPlan& plan);

/// Levels over both plans: at the finer spacing, from the lower lowest to the higher highest.
void joinLevels(const RegularGrid& other, RegularGrid& grid);
/// Leaves the levels that a region touches, at least one.
void cutLevels(const BoxM& region, RegularGrid& grid);

/// "0.8 GiB", "120 MiB".
std::string planSizeText(std::uint64_t bytes);

/// One or two sentences for the screen and for `info`, for example "Every 2 x 2 columns are
/// averaged to one of 2 km: at full resolution the domain would take 3.1 GiB, not 0.8 GiB." Empty
/// if everything is read at full resolution.
std::string describe(const ReadPlan& plan, const DatasetInfo& info);

}  // namespace neph
