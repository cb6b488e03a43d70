// read_plan.cpp: the target grid, and the least coarsening that fits into memory.
#include "core/volume/read_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/dataset/grid_text.h"
#include "core/volume/native_band.h"

namespace neph {
namespace {

constexpr int kMostLevels = 256;
constexpr std::size_t kDepthSamples = 100'000;  // enough layers for a good estimate of the median
constexpr int kFewestSampleRows = 3;
constexpr double kMostEvenColumns = 16'384.0;  // along an axis, whatever a file says
constexpr double kSamePlace = 1e-6;            // of a cell: positions that differ by rounding only
constexpr std::uint64_t kVoxelBytes = sizeof(float);  // of one species, here and on the GPU
// One RGBA32F texture holds three optical classes and the skylight,
// app/render/medium/medium_bake.cpp.
constexpr std::uint64_t kMediumBytes = 16;
constexpr int kClassesPerTexture = 3;

/// The largest number of two significant digits that does not exceed `value`; value > 0.
double roundedDown(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::floor(value / unit + 1e-9) * unit;
}

/// Depths of all layers of a field of heights.
void addDepths(const ColumnField& heights, std::vector<float>& depths) {
    const std::vector<float>& values = heights.values.values;
    const std::size_t layer = heights.levelStride();
    for (std::size_t i = layer; i < values.size(); ++i) {
        depths.push_back(values[i] - values[i - layer]);
    }
}

double median(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return static_cast<double>(*middle);
}

/// Lowest and highest height of one interface.
std::ranges::minmax_result<float> extremes(Dataset& dataset, const VariableInfo& variable, int time,
                                           int level, const Progress& progress) {
    CellBox plane{{0, 0, level}, variable.size};
    plane.upper.z = level + 1;
    return std::ranges::minmax(dataset.read(variable.name, time, plane, progress).values);
}

/// Sets `z` of origin, spacing and size. Spacing and offsets are chosen for the whole depth, so
/// that the levels of a region are a subset of those of the whole domain.
void placeLevels(const NativeLevels& native, const std::optional<BoxM>& region, RegularGrid& grid) {
    double spacing = roundedDown(native.medianDepthM);
    const auto below = [&](double z) { return std::floor(z / spacing + 1e-6); };
    const auto above = [&](double z) { return std::ceil(z / spacing - 1e-6); };
    if (above(native.highestM) - below(native.lowestM) > kMostLevels) {
        spacing = (native.highestM - native.lowestM) / (kMostLevels - 2);
    }
    double first = below(native.lowestM);
    double last = std::max(above(native.highestM), first + 1.0);
    if (region) {
        first = std::max(first, below(region->lowerM.z));
        last = std::min(last, above(region->upperM.z));
    }
    grid.spacingM.z = spacing;
    grid.originM.z = spacing * first;
    grid.size.z = static_cast<int>(last - first);
}

/// The columns of the domain at full resolution: the native ones, or even ones in their place.
struct EvenColumns {
    glm::dvec2 spacingM;
    glm::ivec2 count;
};

EvenColumns evenColumns(const DatasetInfo& info) {
    if (!hasUnevenCells(info)) return {info.spacingM, glm::ivec2(info.size)};
    const glm::dvec2 extent = info.extentM();
    const glm::dvec2 spacing = glm::max(info.spacingM, extent / kMostEvenColumns);
    return {spacing, glm::max(glm::ivec2(glm::ceil(extent / spacing - kSamePlace)), 1)};
}

/// Even columns that a region touches.
CellBox touched(const DatasetInfo& info, const std::optional<BoxM>& region) {
    const EvenColumns columns = evenColumns(info);
    CellBox box{glm::ivec3(0), {columns.count, info.size.z}};
    if (!region) return box;
    for (int axis = 0; axis < 2; ++axis) {
        const double cell = columns.spacingM[axis];
        const double most = columns.count[axis];
        const double lower = std::floor(region->lowerM[axis] / cell + kSamePlace);
        const double upper = std::ceil(region->upperM[axis] / cell - kSamePlace);
        box.lower[axis] = static_cast<int>(std::clamp(lower, 0.0, most));
        box.upper[axis] = static_cast<int>(std::clamp(upper, 0.0, most));
    }
    return box;
}

/// Native columns that lie in `even` ones.
CellBox nativeBox(const DatasetInfo& info, const CellBox& even) {
    if (!hasUnevenCells(info)) return even;
    CellBox box = wholeBox(info);
    const glm::dvec2 spacing = evenColumns(info).spacingM;
    for (int axis = 0; axis < 2; ++axis) {
        const double from = (even.lower[axis] + kSamePlace) * spacing[axis];
        const double to = (even.upper[axis] - kSamePlace) * spacing[axis];
        int& lower = box.lower[axis];
        int& upper = box.upper[axis];
        while (lower < upper && info.edgeM(axis, lower + 1) <= from) ++lower;
        while (lower < upper && info.edgeM(axis, upper - 1) >= to) --upper;
    }
    return box;
}

/// An empty plan would give a volume without cells; the region is at fault, and the message shows
/// its limits.
void requireCells(const Dataset& dataset, const ReadPlan& plan, const NativeLevels& native,
                  const std::optional<BoxM>& region) {
    if (glm::all(glm::greaterThan(plan.even.size(), glm::ivec3(0))) && plan.grid.size.z > 0) return;
    const DatasetInfo& info = dataset.info();
    const glm::dvec2 extent = info.extentM();
    const auto text = [](glm::dvec3 from, glm::dvec3 to) {
        std::string words;
        for (int axis = 0; axis < 3; ++axis) {
            if (!std::isfinite(from[axis]) || !std::isfinite(to[axis])) continue;  // no limit here
            words += fmt::format("{}{} {:.6g} to {:.6g} km", words.empty() ? "" : ", ", "xyz"[axis],
                                 from[axis] * 1e-3, to[axis] * 1e-3);
        }
        return words;
    };
    throw Error({.where = info.times.front().file.string(),
                 .what = "the region asked for holds no cell of the domain",
                 .found = text(region->lowerM, region->upperM),
                 .expected = "a part of " + text({0.0, 0.0, native.lowestM},
                                                 {extent.x, extent.y, native.highestM}),
                 .hint = "from the south-west corner, z above sea level, lower before upper"});
}

/// How many fields the hydrometeors of a data set take.
std::uint64_t speciesOf(const DatasetInfo& info) {
    std::uint64_t species = 0;
    for (int s = 0; s < kSpeciesCount; ++s) {
        if (info.find(VariableRole::mixingRatio, static_cast<Species>(s)) != nullptr) ++species;
    }
    return species;
}

}  // namespace

ReadPlan coarsened(ReadPlan plan, int coarsening, const DatasetInfo& info) {
    plan.coarsening = coarsening;
    const glm::dvec2 spacing = evenColumns(info).spacingM;
    for (int axis = 0; axis < 2; ++axis) {
        plan.grid.size[axis] = (plan.even.size()[axis] + coarsening - 1) / coarsening;
        plan.grid.spacingM[axis] = spacing[axis] * coarsening;
        plan.grid.originM[axis] = spacing[axis] * plan.even.lower[axis];
    }
    countBytes(speciesOf(info), plan);
    return plan;
}

void countBytes(std::uint64_t species, ReadPlan& plan) {
    const std::uint64_t medium = species > kClassesPerTexture ? 2 * kMediumBytes : kMediumBytes;
    plan.machineBytes = plan.grid.cellCount() * species * kVoxelBytes;
    plan.gpuBytes = plan.machineBytes + plan.grid.cellCount() * medium;
}

void joinLevels(const RegularGrid& other, RegularGrid& grid) {
    const double lowest = std::min(grid.originM.z, other.originM.z);
    const double highest = std::max(grid.upperM().z, other.upperM().z);
    const auto set = [&](double spacing) {
        const double first = std::floor(lowest / spacing + kSamePlace);
        grid.spacingM.z = spacing;
        grid.originM.z = spacing * first;
        grid.size.z = static_cast<int>(std::ceil(highest / spacing - kSamePlace) - first);
    };
    set(std::min(grid.spacingM.z, other.spacingM.z));
    if (grid.size.z > kMostLevels) set((highest - lowest) / (kMostLevels - 2));
}

void cutLevels(const BoxM& region, RegularGrid& grid) {
    const double spacing = grid.spacingM.z;
    const double first = std::max(std::round(grid.originM.z / spacing),
                                  std::floor(region.lowerM.z / spacing + kSamePlace));
    const double last = std::min(std::round(grid.upperM().z / spacing),
                                 std::ceil(region.upperM.z / spacing - kSamePlace));
    grid.originM.z = spacing * first;
    grid.size.z = std::max(static_cast<int>(last - first), 1);
}

std::string planSizeText(std::uint64_t bytes) {
    const double mebibytes = static_cast<double>(bytes) / (1U << 20U);
    return mebibytes < 1000.0 ? fmt::format("{:.0f} MiB", mebibytes)
                              : fmt::format("{:.1f} GiB", mebibytes / 1024.0);
}

/// Reads only some rows in between: the median needs a sample, not the whole domain.
NativeLevels readLevels(Dataset& dataset, int time, const Progress& progress) {
    const VariableInfo& variable =
        requiredVariable(dataset, VariableRole::interfaceHeight, "the height of layers");
    const glm::ivec3 size = dataset.info().size;
    const auto perRow = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.z);
    const int rows = std::clamp(static_cast<int>(kDepthSamples / perRow),
                                std::min(kFewestSampleRows, size.y), variable.size.y);
    std::vector<float> depths;
    for (int i = 0; i < rows; ++i) {
        CellBox row = wholeBox(dataset.info());
        row.lower.y = static_cast<int>((i + 0.5) * size.y / rows);
        row.upper.y = row.lower.y + 1;
        addDepths(readHeights(dataset, time, row, progress), depths);
    }
    NativeLevels levels;
    levels.lowestM = static_cast<double>(extremes(dataset, variable, time, 0, progress).min);
    levels.highestM = static_cast<double>(extremes(dataset, variable, time, size.z, progress).max);
    levels.medianDepthM = median(depths);
    return levels;
}

ReadPlan planRead(Dataset& dataset, int time, const std::optional<BoxM>& region,
                  const MemoryBudget& budget, const Progress& progress,
                  const std::optional<NativeLevels>& levels) {
    const DatasetInfo& info = dataset.info();
    const NativeLevels native = levels ? *levels : readLevels(dataset, time, progress);
    ReadPlan plan;
    plan.even = touched(info, region);
    plan.box = nativeBox(info, plan.even);
    plan.grid.movedM = info.times.at(static_cast<std::size_t>(time)).gridOffsetM;
    placeLevels(native, region, plan.grid);
    requireCells(dataset, plan, native, region);
    const int coarsest = std::max(plan.even.size().x, plan.even.size().y);
    for (int coarsening = 1; coarsening <= coarsest; ++coarsening) {
        plan = coarsened(plan, coarsening, info);
        if (plan.machineBytes <= budget.machine && plan.gpuBytes <= budget.gpu) break;
    }
    return plan;
}

std::string describe(const ReadPlan& plan, const DatasetInfo& info) {
    const bool whole = plan.even == touched(info, {});
    std::vector<std::string> sentences;
    if (!whole) {
        const glm::dvec2 extent = info.extentM();
        const glm::dvec2 spacing = evenColumns(info).spacingM;
        const auto corner = [&](glm::ivec3 cell, int axis) {
            return std::min(spacing[axis] * cell[axis], extent[axis]) / 1000.0;
        };
        const glm::ivec3 from = plan.even.lower, to = plan.even.upper;
        sentences.push_back(
            fmt::format("Part of the domain: x {:.4g} to {:.4g} km, y {:.4g} to {:.4g} km.",
                        corner(from, 0), corner(to, 0), corner(from, 1), corner(to, 1)));
    }
    if (!plan.nested.empty()) {
        sentences.push_back(plan.nested);
        return fmt::format("{}", fmt::join(sentences, " "));
    }
    const std::string spacing = plan.grid.spacingM.x == plan.grid.spacingM.y
                                    ? lengthText(plan.grid.spacingM.x)
                                    : fmt::format("{} x {}", lengthText(plan.grid.spacingM.x),
                                                  lengthText(plan.grid.spacingM.y));
    if (hasUnevenCells(info)) {
        sentences.push_back(
            fmt::format("Cells of {} become even ones of {}.", cellWidthText(info), spacing));
    }
    if (plan.coarsening > 1) {
        const ReadPlan full = coarsened(plan, 1, info);
        sentences.push_back(fmt::format(
            "Every {} x {} {}columns are averaged to one of {}: at full resolution {} would take "
            "{}, not {}.",
            plan.coarsening, plan.coarsening, hasUnevenCells(info) ? "even " : "", spacing,
            whole ? "the domain" : "it", planSizeText(full.gpuBytes), planSizeText(plan.gpuBytes)));
    }
    return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace neph
