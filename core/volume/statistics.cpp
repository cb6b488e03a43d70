// statistics.cpp: summarises each band of rows, then merges the bands.
#include "core/volume/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

#include "core/base/quantile.h"
#include "core/volume/native_band.h"
#include "core/volume/possible_air.h"
#include "core/volume/repair.h"

namespace neph {
namespace {

constexpr std::size_t kDepthsOfAll = 100'000;  // enough for a good estimate of the median
constexpr float kOfStrongest = 0.5f;  // of the strongest updraft: what belongs to the main one
constexpr std::array<std::string_view, 3> kWindNames{"W", "w", "winterp"};  // WRF, MicroHH, CM1

void widen(std::optional<HeightRange>& range, const HeightRange& by) {
    if (!range) range = by;
    range->baseM = std::min(range->baseM, by.baseM);
    range->topM = std::max(range->topM, by.topM);
}

/// A column with cloud.
struct CloudyColumn {
    float baseM;
    float strength;  ///< of the updraft: upward wind, or condensate without
};

/// The contribution of one band of rows to the summary of its time.
struct BandSummary {
    TimeSummary found;                 // without medianM, bases and notes
    std::vector<float> depths;         // of a sample of layers
    std::vector<Repairs> repairs;      // of each species
    std::vector<CloudyColumn> cloudy;  // all, from south to north
};

/// What is read of a time.
struct Wanted {
    std::vector<const VariableInfo*> ratios;  // of each species of the series; null where lacking
    std::vector<Species> species;
    const VariableInfo* wind = nullptr;  // upward; null without
};

/// Summarises one band of rows. Each species is read, used and dropped.
class BandLook {
  public:
    BandLook(Dataset& dataset, int time, const CellBox& band, const Progress& progress)
        : dataset_(dataset), time_(time), band_(band), progress_(progress) {}

    BandSummary run(const Wanted& wanted, std::size_t depthStride) {
        heights_ = readHeights(dataset_, time_, band_, progress_);
        columns_ =
            static_cast<std::size_t>(band_.size().x) * static_cast<std::size_t>(band_.size().y);
        layers_ = static_cast<std::size_t>(band_.size().z);
        measureLayers(depthStride);
        weighCells();
        condensate_.assign(columns_, 0.0);
        cloud_.assign(columns_ * layers_, 0.0f);
        precipitation_.assign(columns_ * layers_, 0.0f);
        for (std::size_t i = 0; i < wanted.ratios.size(); ++i) {
            addSpecies(wanted.ratios[i], wanted.species[i]);
        }
        result_.found.condensate = peakOf(condensate_);
        result_.found.cloud = rangeOf(cloud_);
        result_.found.precipitation = rangeOf(precipitation_);
        if (result_.found.cloud) findBases(wanted.wind);
        return std::move(result_);
    }

  private:
    double height(std::size_t column, std::size_t level) const {
        return static_cast<double>(heights_.at(column, level));
    }

    void measureLayers(std::size_t depthStride) {
        LayerSummary& layers = result_.found.layers;
        const auto [lowest, highest] = std::ranges::minmax(heights_.values.values);
        layers.lowestM = static_cast<double>(lowest);
        layers.highestM = static_cast<double>(highest);
        const std::size_t level = heights_.levelStride();
        const std::vector<float>& values = heights_.values.values;
        float thinnest = std::numeric_limits<float>::max();
        float thickest = 0.0f;
        for (std::size_t i = level; i < values.size(); ++i) {
            const float depth = values[i] - values[i - level];
            thinnest = std::min(thinnest, depth);
            thickest = std::max(thickest, depth);
            if (i % depthStride == 0 || heights_.profile) result_.depths.push_back(depth);
        }
        layers.thinnestM = static_cast<double>(thinnest);
        layers.thickestM = static_cast<double>(thickest);
    }

    /// Mass of dry air per square metre in each cell, kg/m².
    void weighCells() {
        if (dataset_.info().find(VariableRole::dryAirDensity) == nullptr) return;
        const ColumnField density = readDensity(dataset_, time_, band_, progress_);
        requireAirOfHeight(dataset_, time_, heights_, density);
        airKgPerM2_.resize(columns_ * layers_);
        for (std::size_t k = 0; k < layers_; ++k) {
            for (std::size_t c = 0; c < columns_; ++c) {
                airKgPerM2_[k * columns_ + c] =
                    density.at(c, k) * (heights_.at(c, k + 1) - heights_.at(c, k));
            }
        }
        result_.found.hasColumns = true;
    }

    /// A species that this time lacks has no peak, and no variable.
    void addSpecies(const VariableInfo* variable, Species species) {
        Repairs& repairs = result_.repairs.emplace_back();
        SpeciesPeak& peak = result_.found.peaks.emplace_back();
        peak.species = species;
        if (variable == nullptr) return;
        const Array3f ratio = readRatio(dataset_, *variable, time_, band_, repairs, progress_);
        findDensest(ratio, peak);
        peak.variable = variable->name;
        if (!airKgPerM2_.empty()) peak.column = heaviest(ratio);
        const bool isCloud = species == Species::cloud || species == Species::ice;
        std::vector<float>& sum = isCloud ? cloud_ : precipitation_;
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += ratio.values[i];
    }

    void findDensest(const Array3f& ratio, SpeciesPeak& peak) const {
        const auto highest = std::ranges::max_element(ratio.values);
        const auto index = static_cast<std::size_t>(std::distance(ratio.values.begin(), highest));
        const std::size_t column = index % columns_;
        const std::size_t layer = index / columns_;
        peak.ratioKgPerKg = *highest;
        const double middle = 0.5 * (height(column, layer) + height(column, layer + 1));
        peak.positionM = {centreOf(column), middle};
    }

    ColumnPeak heaviest(const Array3f& ratio) {
        std::vector<double> mass(columns_, 0.0);
        for (std::size_t k = 0; k < layers_; ++k) {
            for (std::size_t c = 0; c < columns_; ++c) {
                const std::size_t i = k * columns_ + c;
                mass[c] += static_cast<double>(ratio.values[i] * airKgPerM2_[i]);
            }
        }
        for (std::size_t c = 0; c < columns_; ++c) condensate_[c] += mass[c];
        return peakOf(mass);
    }

    ColumnPeak peakOf(const std::vector<double>& mass) const {
        const auto most = std::ranges::max_element(mass);
        return {*most, centreOf(static_cast<std::size_t>(std::distance(mass.begin(), most)))};
    }

    std::optional<HeightRange> rangeOf(const std::vector<float>& ratio) const {
        std::optional<HeightRange> range;
        for (std::size_t k = 0; k < layers_; ++k) {
            for (std::size_t c = 0; c < columns_; ++c) {
                if (ratio[k * columns_ + c] < kCloudRatioKgPerKg) continue;
                widen(range, {height(c, k), height(c, k + 1)});
            }
        }
        return range;
    }

    /// Of each cloudy column its base, and how strong its updraft is.
    void findBases(const VariableInfo* wind) {
        const std::vector<float> strength = wind == nullptr ? condensateOf() : strongestWind(*wind);
        for (std::size_t c = 0; c < columns_; ++c) {
            for (std::size_t k = 0; k < layers_; ++k) {
                if (cloud_[k * columns_ + c] < kCloudRatioKgPerKg) continue;
                result_.cloudy.push_back({heights_.at(c, k), strength[c]});
                break;
            }
        }
    }

    /// kg/m², or, where the density of air is unknown, the sum of mixing ratios.
    std::vector<float> condensateOf() const {
        if (!airKgPerM2_.empty()) return {condensate_.begin(), condensate_.end()};
        std::vector<float> sums(columns_, 0.0f);
        for (std::size_t i = 0; i < cloud_.size(); ++i) {
            sums[i % columns_] += cloud_[i] + precipitation_[i];
        }
        return sums;
    }

    /// The strongest upward wind of each column; values that are missing do not count.
    std::vector<float> strongestWind(const VariableInfo& wind) {
        const ColumnField field = readColumns(dataset_, wind, time_, band_, progress_);
        std::vector<float> strongest(columns_, 0.0f);
        for (std::size_t i = 0; i < field.values.values.size(); ++i) {
            float& most = strongest[i % columns_];
            const float here = field.values.values[i];
            if (std::isfinite(here) && here > most) most = here;
        }
        return strongest;
    }

    glm::dvec2 centreOf(std::size_t column) const {
        const auto width = static_cast<std::size_t>(band_.size().x);
        const glm::ivec2 cell =
            glm::ivec2(band_.lower) +
            glm::ivec2(static_cast<int>(column % width), static_cast<int>(column / width));
        const DatasetInfo& info = dataset_.info();
        glm::dvec2 centre = (glm::dvec2(cell) + 0.5) * info.spacingM;
        for (int axis = 0; axis < 2; ++axis) {
            if (info.edgesM[static_cast<std::size_t>(axis)].empty()) continue;
            centre[axis] = 0.5 * (info.edgeM(axis, cell[axis]) + info.edgeM(axis, cell[axis] + 1));
        }
        return centre;
    }

    Dataset& dataset_;
    const int time_;
    const CellBox band_;
    const Progress& progress_;
    std::size_t columns_ = 0, layers_ = 0;
    ColumnField heights_;
    std::vector<float> airKgPerM2_;  // empty if the density is unknown
    std::vector<double> condensate_;
    std::vector<float> cloud_, precipitation_;
    BandSummary result_;
};

void keepHeavier(ColumnPeak& peak, const ColumnPeak& other) {
    if (other.massKgPerM2 > peak.massKgPerM2) peak = other;
}

void merge(SpeciesPeak& peak, const SpeciesPeak& other) {
    if (other.ratioKgPerKg > peak.ratioKgPerKg) {
        peak.ratioKgPerKg = other.ratioKgPerKg;
        peak.positionM = other.positionM;
    }
    keepHeavier(peak.column, other.column);
}

void merge(LayerSummary& layers, const LayerSummary& other) {
    layers.lowestM = std::min(layers.lowestM, other.lowestM);
    layers.highestM = std::max(layers.highestM, other.highestM);
    layers.thinnestM = std::min(layers.thinnestM, other.thinnestM);
    layers.thickestM = std::max(layers.thickestM, other.thickestM);
}

void merge(BandSummary& all, const BandSummary& band) {
    merge(all.found.layers, band.found.layers);
    for (std::size_t i = 0; i < all.found.peaks.size(); ++i) {
        merge(all.found.peaks[i], band.found.peaks[i]);
        all.repairs[i] += band.repairs[i];
    }
    keepHeavier(all.found.condensate, band.found.condensate);
    if (band.found.cloud) widen(all.found.cloud, *band.found.cloud);
    if (band.found.precipitation) widen(all.found.precipitation, *band.found.precipitation);
    all.depths.insert(all.depths.end(), band.depths.begin(), band.depths.end());
    all.cloudy.insert(all.cloudy.end(), band.cloudy.begin(), band.cloudy.end());
}

double medianOf(std::vector<float>& depths) {
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::ranges::nth_element(depths, middle);
    return static_cast<double>(*middle);
}

/// The variable that holds the upward wind: by its role, or, of readers that give it none, by its
/// name, on layers or on interfaces.
const VariableInfo* upwardWind(const DatasetInfo& info) {
    if (const VariableInfo* wind = info.find(VariableRole::upwardWind)) return wind;
    const auto isWind = [&](const VariableInfo& variable) {
        const bool named = variable.standardName == "upward_air_velocity" ||
                           std::ranges::find(kWindNames, variable.name) != kWindNames.end();
        const int levels = variable.size.z - info.size.z;
        return named && glm::ivec2(variable.size) == glm::ivec2(info.size) &&
               (levels == 0 || levels == 1);
    };
    const auto found = std::ranges::find_if(info.variables, isWind);
    return found == info.variables.end() ? nullptr : &*found;
}

/// `there` is Dataset::infoAt().
Wanted wantedOf(const DatasetInfo& all, const DatasetInfo& there) {
    Wanted wanted;
    for (int s = 0; s < kSpeciesCount; ++s) {
        const auto species = static_cast<Species>(s);
        if (all.find(VariableRole::mixingRatio, species) == nullptr) continue;
        wanted.ratios.push_back(there.find(VariableRole::mixingRatio, species));
        wanted.species.push_back(species);
    }
    wanted.wind = upwardWind(there);
    return wanted;
}

std::optional<CloudBases> basesOf(const std::vector<CloudyColumn>& cloudy,
                                  const VariableInfo* wind) {
    if (cloudy.empty()) return {};
    const float strongest = std::ranges::max(cloudy, {}, &CloudyColumn::strength).strength;
    std::vector<float> all, updraft;
    for (const CloudyColumn& column : cloudy) {
        all.push_back(column.baseM);
        if (column.strength >= kOfStrongest * strongest) updraft.push_back(column.baseM);
    }
    return CloudBases{.lowM = quantile(all, CloudBases::kLowShare),
                      .middleM = quantile(all, 0.5),
                      .updraftM = quantile(updraft, 0.5),
                      .updraftVariable = wind == nullptr ? "" : wind->name};
}

/// Throws Error if what was read cannot be what the model wrote; else what was corrected.
std::vector<std::string> notesOf(const Dataset& dataset, int time, const Wanted& wanted,
                                 const std::vector<Repairs>& repairs) {
    std::vector<std::string> notes = absences(dataset, time);
    std::vector<Repairs> read;
    for (std::size_t i = 0; i < wanted.ratios.size(); ++i) {
        if (wanted.ratios[i] == nullptr) continue;
        const std::string& name = wanted.ratios[i]->name;
        requirePlausible(repairs[i], dataset, time, name);
        read.push_back(repairs[i]);
        std::ranges::move(describe(repairs[i], name), std::back_inserter(notes));
    }
    requireValues(read, dataset, time);
    return notes;
}

}  // namespace

TimeSummary summarise(Dataset& dataset, int time, const Progress& progress) {
    const DatasetInfo& info = dataset.info();
    const DatasetInfo there = dataset.infoAt(time);
    const Wanted wanted = wantedOf(info, there);
    const std::vector<CellBox> bands = bandsOf(wholeBox(info), 1);
    const glm::i64vec3 size = info.size;
    const auto cells = static_cast<std::size_t>(size.x * size.y * size.z);
    const std::size_t stride = (cells / kDepthsOfAll) | 1U;  // odd: does not align with rows
    std::vector<BandSummary> parts(bands.size());
    overBands(
        dataset, bands.size(),
        [&](Dataset& handle, std::size_t band, const Progress& ask) {
            parts[band] = BandLook(handle, time, bands[band], ask).run(wanted, stride);
        },
        progress);
    BandSummary& all = parts.front();
    for (std::size_t band = 1; band < parts.size(); ++band) merge(all, parts[band]);
    all.found.time = time;
    all.found.layers.medianM = medianOf(all.depths);
    all.found.bases = basesOf(all.cloudy, wanted.wind);
    all.found.notes = notesOf(dataset, time, wanted, all.repairs);
    all.found.lowestAir = readLowestAir(dataset, time);
    return std::move(all.found);
}

}  // namespace neph
