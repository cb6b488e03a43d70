// column.cpp: reads a column with a ring of neighbours, which vorticity needs.
#include "core/analysis/column.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/air/thermodynamics.h"
#include "core/analysis/air_block.h"
#include "core/analysis/place.h"
#include "core/analysis/section.h"

namespace neph {
namespace {

std::optional<Sounding> soundingOf(const ColumnReport& report) {
    const Profile* pressure = report.find(Quantity::pressure);
    const Profile* temperature = report.find(Quantity::temperature);
    const Profile* vapour = report.find(Quantity::vapour);
    if (pressure == nullptr || temperature == nullptr || vapour == nullptr) return {};
    const Profile* x = report.find(Quantity::xWind);
    const Profile* y = report.find(Quantity::yWind);
    Sounding sounding;
    sounding.groundM = report.groundM;
    for (std::size_t i = 0; i < report.heightsM.size(); ++i) {
        SoundingLevel level{100.0 * pressure->values[i], report.heightsM[i],
                            temperature->values[i] + kFreezingK,
                            1e-3 * std::max(vapour->values[i], 0.0)};
        const bool known = std::isfinite(level.pressurePa) && std::isfinite(level.temperatureK) &&
                           std::isfinite(level.vapourRatio);
        const bool falls =
            sounding.levels.empty() || level.pressurePa < sounding.levels.back().pressurePa;
        if (!known || !falls) continue;
        if (x != nullptr && y != nullptr && std::isfinite(x->values[i] + y->values[i])) {
            level.windMPerS = {x->values[i], y->values[i]};
        }
        sounding.levels.push_back(level);
    }
    if (sounding.levels.size() < 2) return {};
    return sounding;
}

WindIndices windOf(const Sounding& sounding) {
    const double top = windTopM(sounding);
    WindIndices wind;
    if (top >= 1000.0) wind.shear1MPerS = bulkShearMPerS(sounding, 1000.0);
    if (top < 6000.0) return wind;
    wind.shear6MPerS = bulkShearMPerS(sounding, 6000.0);
    wind.motion = stormMotionOf(sounding);
    wind.helicity1 = stormRelativeHelicity(sounding, 1000.0, wind.motion->rightMPerS);
    wind.helicity3 = stormRelativeHelicity(sounding, 3000.0, wind.motion->rightMPerS);
    return wind;
}

void addHeights(ColumnReport& report) {
    const Profile* temperature = report.find(Quantity::temperature);
    if (temperature == nullptr) return;
    const auto& t = temperature->values;
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        if (t[i] == 0.0 || t[i] * t[i + 1] < 0.0) {
            report.freezingM.push_back(
                std::lerp(report.heightsM[i], report.heightsM[i + 1], t[i] / (t[i] - t[i + 1])));
        }
    }
    report.tropopauseM = tropopauseOf(report.heightsM, t);
}

}  // namespace

const Profile* ColumnReport::find(Quantity quantity) const {
    const auto found = std::ranges::find(profiles, quantity, &Profile::quantity);
    return found == profiles.end() ? nullptr : &*found;
}

ColumnReport readColumn(Dataset& dataset, int time, glm::dvec2 positionM) {
    const DatasetInfo there = dataset.infoAt(time);
    ColumnReport report;
    report.time = time;
    report.column = columnAt(there, positionM);
    report.positionM = centreM(there, report.column);
    report.geo = geoOf(there, time, report.positionM);
    std::vector<Quantity> wanted;
    for (const QuantityInfo& row : kQuantities) {
        const std::string lack = lackOf(row.quantity, there);
        if (lack.empty()) {
            wanted.push_back(row.quantity);
        } else {
            report.lacks.push_back(fmt::format("{}: {}", row.id, lack));
        }
    }
    const AirBlock block(
        dataset, time, {{report.column, 0}, {report.column + glm::ivec2(1), there.size.z}}, wanted);
    report.groundM = block.faceM(report.column, 0);
    for (int level = 0; level < block.levels(); ++level) {
        report.heightsM.push_back(block.middleM({report.column, level}));
    }
    for (const Quantity quantity : wanted) {
        Profile profile{quantity, {}};
        for (int level = 0; level < block.levels(); ++level) {
            profile.values.push_back(block.value(quantity, {report.column, level}));
        }
        report.profiles.push_back(std::move(profile));
    }
    addHeights(report);
    report.sounding = soundingOf(report);
    if (!report.sounding) return report;
    const auto lifted = [&](ParcelSource source) {
        return ascentOf(*report.sounding, parcelOf(*report.sounding, source));
    };
    report.convection =
        ConvectionIndices{lifted(ParcelSource::surface), lifted(ParcelSource::mixedLayer),
                          lifted(ParcelSource::mostUnstable)};
    if (report.sounding->hasWind()) {
        report.wind = windOf(*report.sounding);
        if (!report.wind->motion) {
            report.lacks.push_back(fmt::format(
                "shear and storm motion to 6 km: their wind ends {:.1f} km above the ground",
                1e-3 * windTopM(*report.sounding)));
        }
    }
    return report;
}

}  // namespace neph
