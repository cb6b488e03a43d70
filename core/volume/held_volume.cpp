// held_volume.cpp: plans, reads and summarises the volume of one time.
#include "core/volume/held_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/dataset/whereabouts.h"
#include "core/volume/framing.h"
#include "core/volume/lowest_air.h"
#include "core/volume/run_volume.h"

namespace neph {
namespace {

// Threshold of the visible region where content is held. A droplet cloud of this content has a mean
// free path of 6.7 km ([Riley03] eq. 3, 10 µm), as kVisibleExtinctionPerM.
constexpr float kVisibleContentKgPerM3 = 1e-6f;
constexpr double kMarginShare = 0.1;  // tuned by eye

// Exponent of the lowest histogram bin: far below what is visible; eight decades above it is more
// than any cell contains.
constexpr double kLeastDecadeKgPerM3 = -9.0;
constexpr double kLeastDecadePerM = -7.0;

double leastDecade(Holding holding) {
    return holding == Holding::extinction ? kLeastDecadePerM : kLeastDecadeKgPerM3;
}

/// Bounding box of no cells, to be extended by cells.
constexpr CellBox kNoCells{glm::ivec3(std::numeric_limits<int>::max()), glm::ivec3(0)};

/// Extends `bounds` by the cells above `threshold` and adds all cells above zero to `histogram`.
void lookThrough(const Array3f& field, float threshold, CellBox& bounds,
                 FieldHistogram& histogram) {
    std::size_t i = 0;
    for (int z = 0; z < field.size.z; ++z) {
        for (int y = 0; y < field.size.y; ++y) {
            for (int x = 0; x < field.size.x; ++x, ++i) {
                const float value = field.values[i];
                if (value > 0.0f) histogram.add(value);
                if (value <= threshold) continue;
                bounds.lower = glm::min(bounds.lower, glm::ivec3(x, y, z));
                bounds.upper = glm::max(bounds.upper, glm::ivec3(x, y, z) + 1);
            }
        }
    }
}

}  // namespace

double FieldHistogram::lowerBound(Holding holding, int bin) {
    return std::pow(10.0, leastDecade(holding) + static_cast<double>(bin) / kBinsPerDecade);
}

std::uint64_t FieldHistogram::filled() const {
    return std::accumulate(cells.begin(), cells.end(), below + above);
}

void FieldHistogram::add(float value) {
    least = most > 0.0f ? std::min(least, value) : value;
    most = std::max(most, value);
    const float decades = std::log10(value) - static_cast<float>(leastDecade(holding));
    const auto bin = static_cast<int>(std::floor(decades * kBinsPerDecade));
    if (bin < 0) {
        ++below;
    } else if (bin >= kBins) {
        ++above;
    } else {
        ++cells[static_cast<std::size_t>(bin)];
    }
}

bool VolumeSummary::empty() const {
    return std::ranges::none_of(anything, [](bool some) { return some; });
}

/// One pass over every field, when the volume has just been read.
VolumeSummary summarise(const SpeciesVolume& volume) {
    VolumeSummary summary;
    summary.grid = volume.grid;
    summary.cellM = volume.cellM();
    summary.timeLabel = volume.timeLabel;
    CellBox bounds = kNoCells;
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        FieldHistogram& histogram = summary.histograms[s];
        histogram.holding = volume.holding(static_cast<Species>(s));
        lookThrough(volume.contentKgPerM3[s], kVisibleContentKgPerM3, bounds, histogram);
        lookThrough(volume.extinctionPerM[s], kVisibleExtinctionPerM, bounds, histogram);
        summary.present[s] = histogram.holding != Holding::absent;
        summary.anything[s] = histogram.most > 0.0f;
    }
    if (bounds != kNoCells) {
        const RegularGrid& grid = volume.grid;
        summary.clouds = BoxM{grid.originM + glm::dvec3(bounds.lower) * grid.spacingM,
                              grid.originM + glm::dvec3(bounds.upper) * grid.spacingM};
    }
    summary.seen = seenParts(volume);
    return summary;
}

HeldVolume readVolume(Dataset& dataset, int time, const VolumeRequest& request,
                      const Progress& progress) {
    constexpr double kVolumeShare = 0.97;
    const auto part = [&progress](double from, double to) {
        return Progress([&progress, from, to](double fraction) {
            return goOn(progress, from + (to - from) * fraction);
        });
    };
    RunVolume read = readRuns(dataset, time, request, part(0.0, kVolumeShare));
    HeldVolume held;
    held.volume = std::make_shared<const SpeciesVolume>(std::move(read.volume));
    held.summary = summarise(*held.volume);
    held.summary.plan = read.plan;
    held.summary.domainHeightsM = read.domainHeightsM;
    held.summary.where = whereaboutsOf(dataset.info(), time, held.summary.grid);
    if (request.humidity) addHumidity(held, dataset, time, request.member, part(kVolumeShare, 1.0));
    return held;
}

void addHumidity(HeldVolume& held, Dataset& dataset, int time, int member,
                 const Progress& progress) {
    const LowestAir air = readLowestAirOf(dataset, time, member, progress);
    held.summary.where.humidity = air.humidity;
    held.summary.noHumidity = air.reason;
    held.summary.where.aerosolPerM = air.aerosolPerM;
    held.summary.noAerosol = air.noAerosol;
}

BoxM withMargin(const BoxM& region) {
    const glm::dvec3 margin = kMarginShare * region.sizeM();
    return {region.lowerM - margin, region.upperM + margin};
}

}  // namespace neph
