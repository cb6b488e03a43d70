// statistics.cpp: summarises each band of rows, then merges the bands.
#include "core/volume/statistics.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "core/volume/native_band.h"
#include "core/volume/repair.h"

namespace neph {
namespace {

constexpr std::size_t kDepthsOfAll = 100'000;  // enough for a good estimate of the median

void widen(std::optional<HeightRange>& range, const HeightRange& by) {
    if (!range) range = by;
    range->baseM = std::min(range->baseM, by.baseM);
    range->topM = std::max(range->topM, by.topM);
}

/// The contribution of one band of rows to the summary of its time.
struct BandSummary {
    TimeSummary found;             // without medianM and notes
    std::vector<float> depths;     // of a sample of layers
    std::vector<Repairs> repairs;  // of each species
};

/// Summarises one band of rows. Each species is read, used and dropped.
class BandLook {
  public:
    BandLook(Dataset& dataset, int time, const CellBox& band, const Progress& progress)
        : dataset_(dataset), time_(time), band_(band), progress_(progress) {}

    BandSummary run(const std::vector<const VariableInfo*>& ratios, std::size_t depthStride) {
        heights_ = readHeights(dataset_, time_, band_, progress_);
        columns_ =
            static_cast<std::size_t>(band_.size().x) * static_cast<std::size_t>(band_.size().y);
        layers_ = static_cast<std::size_t>(band_.size().z);
        measureLayers(depthStride);
        weighCells();
        condensate_.assign(columns_, 0.0);
        cloud_.assign(columns_ * layers_, 0.0f);
        precipitation_.assign(columns_ * layers_, 0.0f);
        for (const VariableInfo* variable : ratios) addSpecies(*variable);
        result_.found.condensate = peakOf(condensate_);
        result_.found.cloud = rangeOf(cloud_);
        result_.found.precipitation = rangeOf(precipitation_);
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
        airKgPerM2_.resize(columns_ * layers_);
        for (std::size_t k = 0; k < layers_; ++k) {
            for (std::size_t c = 0; c < columns_; ++c) {
                airKgPerM2_[k * columns_ + c] =
                    density.at(c, k) * (heights_.at(c, k + 1) - heights_.at(c, k));
            }
        }
        result_.found.hasColumns = true;
    }

    void addSpecies(const VariableInfo& variable) {
        Repairs repairs;
        const Array3f ratio = readRatio(dataset_, variable, time_, band_, repairs, progress_);
        SpeciesPeak peak = densest(ratio);
        peak.species = *variable.species;
        peak.variable = variable.name;
        if (!airKgPerM2_.empty()) peak.column = heaviest(ratio);
        result_.found.peaks.push_back(std::move(peak));
        result_.repairs.push_back(repairs);
        const bool isCloud = variable.species == Species::cloud || variable.species == Species::ice;
        std::vector<float>& sum = isCloud ? cloud_ : precipitation_;
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += ratio.values[i];
    }

    SpeciesPeak densest(const Array3f& ratio) const {
        const auto highest = std::ranges::max_element(ratio.values);
        const auto index = static_cast<std::size_t>(std::distance(ratio.values.begin(), highest));
        const std::size_t column = index % columns_;
        const std::size_t layer = index / columns_;
        SpeciesPeak peak;
        peak.ratioKgPerKg = *highest;
        const double middle = 0.5 * (height(column, layer) + height(column, layer + 1));
        peak.positionM = {centreOf(column), middle};
        return peak;
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

    glm::dvec2 centreOf(std::size_t column) const {
        const auto width = static_cast<std::size_t>(band_.size().x);
        const glm::dvec2 cell(static_cast<double>(column % width),
                              static_cast<double>(column / width));
        return (glm::dvec2(band_.lower) + cell + 0.5) * dataset_.info().spacingM;
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
}

double medianOf(std::vector<float>& depths) {
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::ranges::nth_element(depths, middle);
    return static_cast<double>(*middle);
}

std::vector<const VariableInfo*> hydrometeorsOf(const DatasetInfo& info) {
    std::vector<const VariableInfo*> found;
    for (int s = 0; s < kSpeciesCount; ++s) {
        const auto* variable = info.find(VariableRole::mixingRatio, static_cast<Species>(s));
        if (variable != nullptr) found.push_back(variable);
    }
    return found;
}

}  // namespace

TimeSummary summarise(Dataset& dataset, int time, const Progress& progress) {
    const DatasetInfo& info = dataset.info();
    const std::vector<const VariableInfo*> ratios = hydrometeorsOf(info);
    const std::vector<CellBox> bands = bandsOf(wholeBox(info), 1);
    const glm::i64vec3 size = info.size;
    const auto cells = static_cast<std::size_t>(size.x * size.y * size.z);
    const std::size_t stride = (cells / kDepthsOfAll) | 1U;  // odd: does not align with rows
    std::vector<BandSummary> parts(bands.size());
    overBands(
        dataset, bands.size(),
        [&](Dataset& handle, std::size_t band, const Progress& ask) {
            parts[band] = BandLook(handle, time, bands[band], ask).run(ratios, stride);
        },
        progress);
    BandSummary& all = parts.front();
    for (std::size_t band = 1; band < parts.size(); ++band) merge(all, parts[band]);
    all.found.time = time;
    all.found.layers.medianM = medianOf(all.depths);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        std::ranges::move(describe(all.repairs[i], ratios[i]->name),
                          std::back_inserter(all.found.notes));
    }
    return std::move(all.found);
}

}  // namespace neph
