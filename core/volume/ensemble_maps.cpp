// ensemble_maps.cpp: a depth for each member and column, then statistics over members.
#include "core/volume/ensemble_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/number_text.h"
#include "core/geo/map_place.h"
#include "core/volume/column_depth.h"
#include "core/volume/run_volume.h"
#include "core/volume/scale_data.h"

namespace neph {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// Share of the members above the threshold.
double probabilityAt(const EnsembleDepths& depths, std::size_t column, double threshold) {
    std::size_t above = 0;
    for (const std::vector<float>& member : depths.of) {
        if (static_cast<double>(member[column]) > threshold) ++above;
    }
    return static_cast<double>(above) / static_cast<double>(depths.of.size());
}

double meanAt(const EnsembleDepths& depths, std::size_t column) {
    double sum = 0.0;
    for (const std::vector<float>& member : depths.of) sum += static_cast<double>(member[column]);
    return sum / static_cast<double>(depths.of.size());
}

double spreadAt(const EnsembleDepths& depths, std::size_t column) {
    if (depths.of.size() < 2) return kNotKnown;
    const double mean = meanAt(depths, column);
    double sum = 0.0;
    for (const std::vector<float>& member : depths.of) {
        const double off = static_cast<double>(member[column]) - mean;
        sum += off * off;
    }
    return std::sqrt(sum / static_cast<double>(depths.of.size() - 1));
}

/// Which species a volume has any of, added to those known.
void lookFor(const SpeciesVolume& volume, VolumeSummary& found) {
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        for (const Array3f* field : {&volume.contentKgPerM3[s], &volume.extinctionPerM[s]}) {
            found.anything[s] =
                found.anything[s] ||
                std::ranges::any_of(field->values, [](float v) { return v > 0.0f; });
        }
    }
}

/// Whether the depths of such a look are those of the data; detail noise is not in them.
std::string scaleOf(Look look, const DatasetInfo& info, const VolumeSummary& found) {
    look.noise = false;
    return scaleText(notToScale(look, scaleDataOf(info, found)));
}

}  // namespace

glm::dvec2 EnsembleDepths::centreM(std::size_t column) const {
    const auto width = static_cast<std::size_t>(grid.size.x);
    return glm::dvec2(
        grid.centreM({static_cast<int>(column % width), static_cast<int>(column / width), 0}));
}

std::vector<GeoPoint> EnsembleDepths::places() const {
    std::vector<GeoPoint> all;
    if (map.projection.empty()) return all;
    const MapPlace place(map);
    for (std::size_t i = 0; i < columns(); ++i) {
        all.push_back(place.geoAt(centreM(i)).value_or(GeoPoint{kNotKnown, kNotKnown}));
    }
    return all;
}

std::vector<float> mapOf(const EnsembleDepths& depths, EnsembleMap map, double threshold) {
    std::vector<float> values(depths.columns());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = map == EnsembleMap::probability ? probabilityAt(depths, i, threshold)
                             : map == EnsembleMap::mean      ? meanAt(depths, i)
                                                             : spreadAt(depths, i);
        values[i] = static_cast<float>(value);
    }
    return values;
}

std::string titleOf(EnsembleMap map, double threshold) {
    switch (map) {
        case EnsembleMap::probability:
            return fmt::format("Probability of optical depth > {}", numberText(threshold, 6));
        case EnsembleMap::mean:
            return "Mean optical depth";
        case EnsembleMap::spread:
            break;
    }
    return "Spread of the optical depth (standard deviation)";
}

EnsembleDepths readEnsembleDepths(Ensemble& ensemble, int time, VolumeRequest request,
                                  const Look& look, const KnownVolumes& known,
                                  const Progress& progress) {
    request.humidity = false;
    const TimeInfo& when = ensemble.info().times.at(static_cast<std::size_t>(time));
    EnsembleDepths depths;
    depths.timeLabel = when.label;
    depths.utc = when.utc;
    depths.map = ensemble.info().map;
    depths.map.originM += when.gridOffsetM * depths.map.mapPerGrid;
    VolumeSummary found;
    const auto count = static_cast<double>(ensemble.count());
    for (int member = 0; member < ensemble.count(); ++member) {
        if (!ensemble.timeIn(member, time)) {
            depths.without.push_back(ensemble.nameOf(member));
            continue;
        }
        const Progress part = [&](double share) {
            return goOn(progress, (member + share) / count);
        };
        const auto index = static_cast<std::size_t>(member);
        std::shared_ptr<const SpeciesVolume> volume = index < known.size() ? known[index] : nullptr;
        if (!volume) {
            volume = std::make_shared<const SpeciesVolume>(
                readMember(ensemble, member, time, request, part).volume);
        }
        if (depths.members.empty()) depths.grid = volume->grid;
        requireSameGrid(volume->grid, depths.grid, ensemble.nameOf(member));
        lookFor(*volume, found);
        depths.members.push_back(ensemble.nameOf(member));
        depths.of.push_back(
            columnDepths(*volume, planMedium(look, volume->holdings(), volume->cellM())));
    }
    depths.scale = scaleOf(look, ensemble.info(), found);
    return depths;
}

}  // namespace neph
