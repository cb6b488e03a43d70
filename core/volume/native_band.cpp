// native_band.cpp: reads and checks bands, and distributes them over threads.
#include "core/volume/native_band.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/volume/possible_air.h"

namespace neph {
namespace {

constexpr std::size_t kBandBytes = 1U << 20U;  // per field: a few of them fit into a core's cache
constexpr std::size_t kMostThreads = 4;        // more would be limited by memory, not by computing

std::string textOf(glm::ivec3 size) {
    return fmt::format("{} x {} x {}", size.x, size.y, size.z);
}

/// A grid of one column has no profiles: there the two are the same.
bool isProfile(const VariableInfo& variable, const DatasetInfo& info) {
    return variable.size.x == 1 && variable.size.y == 1 && (info.size.x > 1 || info.size.y > 1);
}

/// One handle that several threads read through by turns.
class SharedHandle final : public Dataset {
  public:
    explicit SharedHandle(Dataset& dataset) : dataset_(dataset) { info_ = dataset.info(); }
    bool has(std::string_view variable, int time) const override {
        return dataset_.has(variable, time);
    }
    Array3f read(std::string_view variable, int time, std::optional<CellBox> box,
                 const Progress& progress) override {
        const std::lock_guard lock(mutex_);
        return dataset_.read(variable, time, box, progress);
    }

  private:
    Dataset& dataset_;
    std::mutex mutex_;
};

/// A value that cannot be used.
struct BadCell {
    std::size_t index;  ///< into the values of the band
    std::string expected;
};

/// Names the file, variable, time and cell of an unusable value.
Error errorOf(const Dataset& dataset, int time, const VariableInfo& variable, const CellBox& band,
              const ColumnField& field, const BadCell& bad) {
    const TimeInfo& when = dataset.info().times.at(static_cast<std::size_t>(time));
    const auto width = static_cast<std::size_t>(field.values.size.x);
    const std::size_t layer = field.levelStride();
    const glm::ivec3 lower = field.profile ? glm::ivec3(0, 0, band.lower.z) : band.lower;
    const glm::ivec3 cell =
        lower + glm::ivec3(bad.index % width, bad.index % layer / width, bad.index / layer);
    return Error({.where = when.file.string(),
                  .what = fmt::format("variable {} is unusable at {}", variable.name, when.label),
                  .found = fmt::format("{} in cell x {}, y {}, level {} ({})",
                                       field.values.values[bad.index], cell.x, cell.y, cell.z,
                                       variable.description),
                  .expected = bad.expected,
                  .hint = "the run blew up or the file is damaged: leave this time out"});
}

}  // namespace

CellBox wholeBox(const DatasetInfo& info) {
    return {glm::ivec3(0), info.size};
}

bool hasUnevenCells(const DatasetInfo& info) {
    return !info.edgesM[0].empty() || !info.edgesM[1].empty();
}

std::vector<CellBox> bandsOf(const CellBox& box, int coarsening) {
    const std::size_t row = static_cast<std::size_t>(box.size().x) *
                            static_cast<std::size_t>(box.size().z) * sizeof(float);
    const int blocks =
        std::max(static_cast<int>(kBandBytes / row / static_cast<std::size_t>(coarsening)), 1);
    std::vector<CellBox> bands;
    for (int y = box.lower.y; y < box.upper.y;) {
        CellBox band = box;
        band.lower.y = y;
        band.upper.y = std::min(y + blocks * coarsening, box.upper.y);
        y = band.upper.y;
        bands.push_back(band);
    }
    return bands;
}

void requireOnGrid(const Dataset& dataset, const VariableInfo& variable, bool profiles) {
    const DatasetInfo& info = dataset.info();
    glm::ivec3 expected = info.size;
    if (variable.role == VariableRole::interfaceHeight) ++expected.z;
    if (variable.size == expected) return;
    const glm::ivec3 profile(1, 1, expected.z);
    if (profiles && variable.size == profile) return;
    throw Error({.where = info.times.front().file.string(),
                 .what = fmt::format("variable {} does not lie on the grid", variable.name),
                 .found = textOf(variable.size),
                 .expected = textOf(expected) + (profiles ? " or " + textOf(profile) : "")});
}

const VariableInfo& requiredVariable(const Dataset& dataset, VariableRole role,
                                     std::string_view meaning) {
    if (const VariableInfo* variable = dataset.info().find(role)) {
        requireOnGrid(dataset, *variable, true);
        return *variable;
    }
    throw Error({.where = dataset.info().times.front().file.string(),
                 .what = fmt::format("{} cannot be had from this file", meaning),
                 .expected = "a variable of that role from the reader"});
}

std::vector<std::string> absences(const Dataset& dataset, int time) {
    std::vector<std::string> notes;
    const DatasetInfo& all = dataset.info();
    const DatasetInfo there = dataset.infoAt(time);
    const TimeInfo& when = all.times.at(static_cast<std::size_t>(time));
    for (std::size_t s = 0; s < kSpecies.size(); ++s) {
        const auto species = static_cast<Species>(s);
        const VariableInfo* known = all.find(VariableRole::mixingRatio, species);
        if (known == nullptr || there.find(VariableRole::mixingRatio, species) != nullptr) continue;
        notes.push_back(fmt::format("{} is not in {}: there is no {} at this time.", known->name,
                                    when.file.filename().string(), info(species).id));
    }
    return notes;
}

ColumnField readColumns(Dataset& dataset, const VariableInfo& variable, int time,
                        const CellBox& band, const Progress& progress) {
    CellBox box = band;
    box.upper.z += variable.size.z - dataset.info().size.z;
    ColumnField field;
    field.profile = isProfile(variable, dataset.info());
    if (field.profile) {
        box.lower = {0, 0, box.lower.z};
        box.upper = {1, 1, box.upper.z};
    }
    field.values = dataset.read(variable.name, time, box, progress);
    requirePossibleAir(dataset, time, variable, box, field.values);
    return field;
}

ColumnField readHeights(Dataset& dataset, int time, const CellBox& band, const Progress& progress) {
    const VariableInfo& variable =
        requiredVariable(dataset, VariableRole::interfaceHeight, "the height of layers");
    ColumnField heights = readColumns(dataset, variable, time, band, progress);
    const std::vector<float>& values = heights.values.values;
    const std::size_t layer = heights.levelStride();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) {
            throw errorOf(dataset, time, variable, band, heights, {i, "heights in metres"});
        }
        if (i >= layer && !(values[i] > values[i - layer])) {
            throw errorOf(
                dataset, time, variable, band, heights,
                {i, fmt::format("more than the {} of the level below", values[i - layer])});
        }
    }
    return heights;
}

ColumnField readDensity(Dataset& dataset, int time, const CellBox& band, const Progress& progress) {
    const VariableInfo& variable =
        requiredVariable(dataset, VariableRole::dryAirDensity, "the density of dry air");
    return readColumns(dataset, variable, time, band, progress);
}

Array3f readRatio(Dataset& dataset, const VariableInfo& variable, int time, const CellBox& band,
                  Repairs& repairs, const Progress& progress, int countedFrom) {
    Array3f ratio = dataset.read(variable.name, time, band, progress);
    repairs += repair(ratio, countedFrom);
    return ratio;
}

void overBands(Dataset& dataset, std::size_t bandCount, const BandWork& work,
               const Progress& progress) {
    const std::size_t workers = std::min(workerCount(kMostThreads), bandCount);
    if (dataset.info().rowsTogether > 1) {
        // Bands and rows that are stored together seldom end at the same row: with one handle, what
        // two bands need is still read once.
        SharedHandle shared(dataset);
        shareOut(
            bandCount, workers,
            [&](std::size_t band, std::size_t, const Progress& report) {
                work(shared, band, report);
            },
            progress);
        return;
    }
    std::vector<std::unique_ptr<Dataset>> handles;
    while (handles.size() + 1 < workers) {
        auto handle = dataset.anotherHandle();
        if (!handle) break;
        handles.push_back(std::move(handle));
    }
    // Each worker takes one run of neighbouring bands, so that what a reader has cached (a row of
    // chunks) also serves the next band, and few rows are needed by two readers.
    const std::size_t runs = handles.size() + 1;
    shareOut(
        runs, handles.size() + 1,
        [&](std::size_t run, std::size_t worker, const Progress& report) {
            const std::size_t end = (run + 1) * bandCount / runs;
            for (std::size_t band = run * bandCount / runs; band < end; ++band) {
                if (!goOn(report, 0.0)) throw Cancelled{};
                work(worker == 0 ? dataset : *handles[worker - 1], band, report);
            }
        },
        progress);
}

}  // namespace neph
