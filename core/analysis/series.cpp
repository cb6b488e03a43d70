// series.cpp: sums and extremes of one time, band by band.
#include "core/analysis/series.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/air_block.h"
#include "core/analysis/place.h"
#include "core/base/quantile.h"
#include "core/volume/statistics.h"

namespace neph {
namespace {

/// What bands add up to.
struct BandSums {
    std::array<std::optional<Extreme>, kSpeciesCount> most;
    std::optional<Extreme> up, down, dbz;
    std::array<double, kSpeciesCount> massKg{};
    double topM = -std::numeric_limits<double>::infinity();
    std::vector<float> basesM;
    double cloudyM2 = 0.0;
};

void keepMost(std::optional<Extreme>& most, double value, const glm::dvec3& atM, double sign = 1) {
    if (std::isnan(value)) return;
    if (!most || sign * value > sign * most->value) most = Extreme{value, atM};
}

void join(std::optional<Extreme>& most, const std::optional<Extreme>& other, double sign = 1) {
    if (other) keepMost(most, other->value, other->positionM, sign);
}

/// What is read of one time.
struct Wanted {
    std::vector<Quantity> quantities;
    bool density = false;

    bool has(Quantity quantity) const {
        return std::ranges::find(quantities, quantity) != quantities.end();
    }
};

Wanted wantedOf(const DatasetInfo& there) {
    Wanted wanted;
    for (const QuantityInfo& row : kQuantities) {
        const bool used = static_cast<int>(row.quantity) < kSpeciesCount ||
                          row.quantity == Quantity::upwardWind ||
                          row.quantity == Quantity::reflectivity;
        if (used && lackOf(row.quantity, there).empty()) wanted.quantities.push_back(row.quantity);
    }
    wanted.density = there.find(VariableRole::dryAirDensity) != nullptr;
    return wanted;
}

class BandSummer {
  public:
    BandSummer(Dataset& dataset, int time, const CellBox& band, const Wanted& wanted)
        : info_(dataset.info()),
          band_(band),
          wanted_(wanted),
          block_(dataset, time, band, wanted.quantities) {
        if (wanted.density) density_ = readDensity(dataset, time, band);
    }

    BandSums sum() {
        for (int y = band_.lower.y; y < band_.upper.y; ++y) {
            for (int x = band_.lower.x; x < band_.upper.x; ++x) addColumn({x, y});
        }
        return std::move(sums_);
    }

  private:
    void addColumn(glm::ivec2 column) {
        const double area = (info_.edgeM(0, column.x + 1) - info_.edgeM(0, column.x)) *
                            (info_.edgeM(1, column.y + 1) - info_.edgeM(1, column.y));
        bool cloudy = false;
        for (int level = 0; level < info_.size.z; ++level) {
            const glm::ivec3 cell(column, level);
            const double cloud = addCell(cell, area);
            if (cloud < kCloudRatioGPerKg) continue;
            if (!cloudy) sums_.basesM.push_back(static_cast<float>(block_.faceM(column, level)));
            cloudy = true;
            sums_.topM = std::max(sums_.topM, block_.faceM(column, level + 1));
        }
        if (cloudy) sums_.cloudyM2 += area;
    }

    /// Its cloud water and ice, g/kg.
    double addCell(glm::ivec3 cell, double area) {
        const glm::ivec2 column(cell);
        const glm::dvec3 atM(centreM(info_, column), block_.middleM(cell));
        double cloud = 0.0;
        for (int s = 0; s < kSpeciesCount; ++s) {
            const auto quantity = static_cast<Quantity>(s);
            if (!wanted_.has(quantity)) continue;
            const double ratio = block_.value(quantity, cell);
            const auto index = static_cast<std::size_t>(s);
            keepMost(sums_.most[index], ratio, atM);
            if (quantity == Quantity::cloud || quantity == Quantity::ice) cloud += ratio;
            if (density_ && ratio > 0.0) sums_.massKg[index] += 1e-3 * ratio * airKg(cell, area);
        }
        if (wanted_.has(Quantity::upwardWind)) {
            const double wind = block_.value(Quantity::upwardWind, cell);
            keepMost(sums_.up, wind, atM);
            keepMost(sums_.down, wind, atM, -1);
        }
        if (wanted_.has(Quantity::reflectivity)) {
            keepMost(sums_.dbz, block_.value(Quantity::reflectivity, cell), atM);
        }
        return cloud;
    }

    double airKg(glm::ivec3 cell, double area) const {
        const glm::ivec2 column(cell);
        const glm::ivec3 own = cell - band_.lower;
        const auto at = static_cast<std::size_t>(own.x + own.y * band_.size().x);
        return static_cast<double>(density_->at(at, static_cast<std::size_t>(own.z))) * area *
               (block_.faceM(column, cell.z + 1) - block_.faceM(column, cell.z));
    }

    const DatasetInfo& info_;
    CellBox band_;
    const Wanted& wanted_;
    AirBlock block_;
    std::optional<ColumnField> density_;
    BandSums sums_;
};

void add(BandSums& all, BandSums&& band) {
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        join(all.most[s], band.most[s]);
        all.massKg[s] += band.massKg[s];
    }
    join(all.up, band.up);
    join(all.down, band.down, -1);
    join(all.dbz, band.dbz);
    all.topM = std::max(all.topM, band.topM);
    all.cloudyM2 += band.cloudyM2;
    all.basesM.insert(all.basesM.end(), band.basesM.begin(), band.basesM.end());
}

}  // namespace

SeriesPoint readSeriesPoint(Dataset& dataset, int time, const Progress& progress) {
    const DatasetInfo& info = dataset.info();
    const Wanted wanted = wantedOf(dataset.infoAt(time));
    const std::vector<CellBox> bands = bandsOf(wholeBox(info), 1);
    std::vector<BandSums> sums(bands.size());
    overBands(
        dataset, bands.size(),
        [&](Dataset& handle, std::size_t band, const Progress&) {
            sums[band] = BandSummer(handle, time, bands[band], wanted).sum();
        },
        progress);
    BandSums all;
    for (BandSums& band : sums) add(all, std::move(band));
    SeriesPoint point;
    point.time = time;
    point.seconds = info.times.at(static_cast<std::size_t>(time)).seconds;
    point.mostGPerKg = all.most;
    point.updraftMPerS = all.up;
    point.downdraftMPerS = all.down;
    point.reflectivityDbz = all.dbz;
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        if (all.most[s] && wanted.density) point.massKg[s] = all.massKg[s];
    }
    if (!all.basesM.empty()) {
        point.stormTopM = all.topM;
        point.baseM = quantile(all.basesM, CloudBases::kLowShare);
    }
    point.cover = all.cloudyM2 / (info.extentM().x * info.extentM().y);
    return point;
}

}  // namespace neph
