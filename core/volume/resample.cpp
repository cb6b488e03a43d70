// resample.cpp: bands of native columns, averaged to coarse columns and remapped to regular levels.
#include "core/volume/resample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>
#include <vector>

#include "core/base/error.h"
#include "core/volume/blocks.h"
#include "core/volume/native_band.h"
#include "core/volume/possible_air.h"
#include "core/volume/repair.h"

namespace neph {
namespace {

/// Slope of content within layer k, per metre: the central difference, but never so steep that the
/// line leaves the range of the neighbouring means (van Leer's limiter on uneven layers).
double limitedSlope(std::span<const double> interfaces, std::span<const double> content,
                    std::size_t k) {
    if (k == 0 || k + 1 == content.size()) return 0.0;
    const double below = content[k] - content[k - 1];
    const double above = content[k + 1] - content[k];
    if (below * above <= 0.0) return 0.0;
    const double depth = interfaces[k + 1] - interfaces[k];
    const double reach = 0.5 * (interfaces[k + 2] + interfaces[k + 1] - interfaces[k] -
                                interfaces[k - 1]);  // from the centre below to the centre above
    const double central = std::abs(below + above) / reach;
    const double steepest = 2.0 * std::min(std::abs(below), std::abs(above)) / depth;
    return std::copysign(std::min(central, steepest), below);
}

/// Remaps the blocks of one band to the levels of `out`, starting at row `firstRow`.
void remap(std::span<const double> interfaces, std::span<const double> quantity, std::size_t blocks,
           const RegularGrid& grid, int firstRow, Array3f& out) {
    const std::size_t layers = quantity.size() / blocks;
    const std::size_t first = out.index(0, firstRow, 0);
    const std::size_t layer = out.index(0, 0, 1);
    std::vector<double> column(layers + 1), content(layers);
    std::vector<double> target(static_cast<std::size_t>(grid.size.z));
    for (std::size_t block = 0; block < blocks; ++block) {
        double most = 0.0;
        for (std::size_t k = 0; k < layers; ++k) {
            content[k] = quantity[block + k * blocks];
            most = std::max(most, content[k]);
        }
        if (most == 0.0) continue;
        for (std::size_t k = 0; k <= layers; ++k) column[k] = interfaces[block + k * blocks];
        std::ranges::fill(target, 0.0);
        resampleColumn(column, content, grid.originM.z, grid.spacingM.z, target);
        for (std::size_t k = 0; k < target.size(); ++k) {
            out.values[first + block + k * layer] = static_cast<float>(target[k]);
        }
    }
}

/// The state of one species while it is resampled.
struct SpeciesWork {
    const VariableInfo* ratio;
    Array3f* out;
    Repairs repairs{};
    RadiusGaps gaps{};

    Species species() const { return *ratio->species; }
};

/// The air of a band, needed for every species; read only if one of them has any condensate.
struct BandAir {
    ColumnField heights, density;
    std::vector<double> interfaces;  ///< of the blocks, block fastest
    bool empty() const { return interfaces.empty(); }
};

/// Resamples all species, band by band, on several threads.
class BandResampler {
  public:
    BandResampler(const ReadPlan& plan, const RadiusPlan& radii, int time,
                  std::vector<SpeciesWork>& species, std::vector<TargetBand> bands)
        : plan_(plan), radii_(radii), time_(time), species_(species), bands_(std::move(bands)) {}

    void run(Dataset& dataset, const Progress& progress) {
        overBands(
            dataset, bands_.size(),
            [this](Dataset& handle, std::size_t band, const Progress& report) {
                take(handle, bands_[band], report);
            },
            progress);
    }

  private:
    /// Reads heights and density only for bands with condensate.
    void take(Dataset& dataset, const TargetBand& target, const Progress& progress) {
        const Blocks blocks(plan_, dataset.info(), target);
        const CellBox& band = target.native;
        BandAir air;
        for (SpeciesWork& species : species_) {
            Repairs repairs;
            Array3f quantity =
                readRatio(dataset, *species.ratio, time_, band, repairs, progress, target.ownRow);
            {
                const std::lock_guard lock(mutex_);
                species.repairs += repairs;
            }
            if (repairs.allZero) continue;
            if (air.empty()) air = readAir(dataset, band, blocks, progress);
            timesDensity(quantity, air.density);
            if (!radii_.holdsMass(species.species())) {
                toExtinction(dataset, band, air.density, species, quantity, progress);
            }
            remap(air.interfaces, blocks.averaged(quantity, air.heights, air.interfaces),
                  blocks.count(), plan_.grid, target.firstRow, *species.out);
        }
    }

    BandAir readAir(Dataset& dataset, const CellBox& band, const Blocks& blocks,
                    const Progress& progress) const {
        BandAir air;
        air.heights = readHeights(dataset, time_, band, progress);
        air.density = readDensity(dataset, time_, band, progress);
        requireAirOfHeight(dataset, time_, air.heights, air.density);
        air.interfaces = blocks.means(air.heights);
        return air;
    }

    /// Converts in place from per kg of dry air to per m³.
    static void timesDensity(Array3f& perKg, const ColumnField& density) {
        const std::size_t layer = perKg.index(0, 0, 1);
        for (std::size_t k = 0; k < static_cast<std::size_t>(perKg.size.z); ++k) {
            float* values = perKg.values.data() + k * layer;
            for (std::size_t i = 0; i < layer; ++i) values[i] *= density.at(i, k);
        }
    }

    /// Values for every cell: a profile is repeated for each column.
    static Array3f spread(ColumnField field, glm::ivec3 size) {
        if (!field.profile) return std::move(field.values);
        Array3f values(size);
        const std::size_t layer = values.index(0, 0, 1);
        for (std::size_t i = 0; i < values.values.size(); ++i) {
            values.values[i] = field.at(0, i / layer);
        }
        return values;
    }

    /// Converts in place from content to extinction, on native cells: extinction does not follow
    /// from mean content.
    void toExtinction(Dataset& dataset, const CellBox& band, const ColumnField& density,
                      SpeciesWork& work, Array3f& quantity, const Progress& progress) {
        const RadiusRule& rule = radii_.of(work.species());
        const auto readExtra = [&](const std::string& name) {
            const VariableInfo* variable = dataset.info().find(name);
            if (variable == nullptr) return Array3f();
            return spread(readColumns(dataset, *variable, time_, band, progress), band.size());
        };
        const Array3f radius = readExtra(rule.radiusVariable);
        Array3f number = readExtra(rule.numberVariable);
        if (!number.empty()) timesDensity(number, density);
        const Array3f temperature = readExtra(rule.temperatureVariable);
        const RadiusGaps gaps = contentToExtinction(
            radii_, work.species(), {radius.values, number.values, temperature.values},
            quantity.values);
        const std::lock_guard lock(mutex_);
        work.gaps += gaps;
    }

    const ReadPlan& plan_;
    const RadiusPlan& radii_;
    const int time_;
    std::vector<SpeciesWork>& species_;
    const std::vector<TargetBand> bands_;
    std::mutex mutex_;  // guards repairs and gaps; each band writes its own rows of the result
};

/// Throws Error if what was read cannot be what the model wrote.
void requireRead(const std::vector<SpeciesWork>& species, const Dataset& dataset, int time) {
    std::vector<Repairs> all;
    for (const SpeciesWork& work : species) {
        requirePlausible(work.repairs, dataset, time, work.ratio->name);
        all.push_back(work.repairs);
    }
    requireValues(all, dataset, time);
}

/// Collects what was assumed, missing or corrected. What holds at this time only names it.
void addNotes(const std::vector<SpeciesWork>& species, const RadiusPlan& radii,
              const std::vector<std::string>& absent, SpeciesVolume& volume) {
    std::vector<std::string> empty;
    const auto add = [&](std::string_view note) {
        volume.notes.push_back(fmt::format("{}: {}", volume.timeLabel, note));
    };
    std::ranges::copy(radii.notes, std::back_inserter(volume.notes));
    for (const std::string& note : absent) add(note);
    for (const SpeciesWork& work : species) {
        const std::string gaps = describe(work.gaps, radii.of(work.species()), work.species());
        if (!gaps.empty()) add(gaps);
        for (const std::string& note : describe(work.repairs, work.ratio->name)) add(note);
        if (work.repairs.allZero) empty.push_back(work.ratio->name);
    }
    if (species.empty() && absent.empty()) {
        volume.notes.emplace_back("This file has no hydrometeors (QCLOUD, QICE, QRAIN, ...).");
    } else if (empty.size() == species.size()) {
        volume.notes.push_back(fmt::format(
            "There is no condensate at {}: every mixing ratio is zero.", volume.timeLabel));
    } else {
        for (const std::string& name : empty) add(name + ": zero everywhere at this time.");
    }
}

}  // namespace

Array3f readInterfaceHeights(Dataset& dataset, int time, const Progress& progress) {
    return readHeights(dataset, time, wholeBox(dataset.info()), progress).values;
}

double medianLayerDepth(const Array3f& heights) {
    const std::size_t layer = heights.values.size() / static_cast<std::size_t>(heights.size.z);
    const std::size_t count = heights.values.size() - layer;
    // Large fields are sampled: about 100,000 layers give a good estimate of the median.
    std::size_t stride = std::max<std::size_t>(1, count / 100'000);
    if (stride > 1) stride |= 1U;  // odd, so that the samples do not align with rows
    std::vector<float> depths;
    for (std::size_t i = 0; i < count; i += stride) {
        depths.push_back(heights.values[i + layer] - heights.values[i]);
    }
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::ranges::nth_element(depths, middle);
    return static_cast<double>(*middle);
}

void resampleColumn(std::span<const double> interfacesM, std::span<const double> content,
                    double bottomM, double spacingM, std::span<double> target) {
    const double perSpacing = 1.0 / spacingM;
    const auto last = static_cast<std::ptrdiff_t>(target.size()) - 1;
    for (std::size_t k = 0; k < content.size(); ++k) {
        if (content[k] == 0.0) continue;
        const double lower = interfacesM[k];
        const double upper = interfacesM[k + 1];
        const double centre = 0.5 * (lower + upper);
        const double slope = limitedSlope(interfacesM, content, k);
        const double first = std::floor((lower - bottomM) * perSpacing);
        auto cell = first > 0.0 ? static_cast<std::ptrdiff_t>(first) : 0;
        for (; cell <= last; ++cell) {
            const double cellLower = bottomM + spacingM * static_cast<double>(cell);
            if (cellLower >= upper) break;
            const double from = std::max(lower, cellLower);
            const double to = std::min(upper, cellLower + spacingM);
            if (to <= from) continue;
            const double mean = content[k] + slope * (0.5 * (from + to) - centre);
            target[static_cast<std::size_t>(cell)] += mean * (to - from) * perSpacing;
        }
    }
}

SpeciesVolume resample(Dataset& dataset, int time, const ResampleOptions& options,
                       const Progress& progress) {
    const DatasetInfo info = dataset.infoAt(time);
    const ReadPlan plan = options.plan ? *options.plan : planRead(dataset, time);
    SpeciesVolume volume;
    volume.grid = plan.grid;
    volume.nativeCellM = meanCellM(info.spacingM);
    volume.timeLabel = info.times.at(static_cast<std::size_t>(time)).label;
    volume.timeSeconds = info.times.at(static_cast<std::size_t>(time)).seconds;
    const RadiusPlan radii = planAt(options.radii, info, volume.timeLabel);
    std::vector<SpeciesWork> species;
    for (std::size_t s = 0; s < kSpecies.size(); ++s) {
        const auto* ratio = info.find(VariableRole::mixingRatio, static_cast<Species>(s));
        if (ratio == nullptr) continue;
        requireOnGrid(dataset, *ratio, false);
        const RadiusRule& rule = radii.rules[s];
        for (const std::string* name :
             {&rule.radiusVariable, &rule.numberVariable, &rule.temperatureVariable}) {
            const VariableInfo* variable = info.find(*name);
            const bool profile = name == &rule.temperatureVariable;
            if (variable != nullptr) requireOnGrid(dataset, *variable, profile);
        }
        const bool mass = rule.source == RadiusSource::constant;
        Array3f& out = mass ? volume.contentKgPerM3[s] : volume.extinctionPerM[s];
        out = Array3f(plan.grid.size);
        species.push_back({ratio, &out});
    }
    requiredVariable(dataset, VariableRole::dryAirDensity, "the density of dry air");
    BandResampler(plan, radii, time, species, targetBands(plan, info)).run(dataset, progress);
    requireRead(species, dataset, time);
    addNotes(species, radii, absences(dataset, time), volume);
    return volume;
}

}  // namespace neph
