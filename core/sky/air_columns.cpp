// air_columns.cpp: rays through layers of air, and a table of them over altitude and true elevation
// that does not depend on how dense the air is.
#include "core/sky/air_columns.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/sky/atmosphere.h"
#include "core/sky/solar_position.h"

namespace neph {
namespace {

using glm::dvec3, glm::dvec4;

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr glm::ivec2 kTableSize{512, 128};  // elevations, altitudes

double withinAir(double altitudeM) {
    return std::clamp(altitudeM, 0.0, kAtmosphereTopM);
}

/// n r.
double scaledRadiusM(double altitudeM) {
    return raisedEarthRadiusM() + raisedOfAltitude(altitudeM);
}

/// Columns and bending, up from where it is or level; `radiusM` is n r.
dvec4 upwards(double radiusM, double up) {
    constexpr int kSteps = 64;
    const double b = radiusM * up, level = radiusM * std::sqrt(std::max(0.0, 1.0 - up * up));
    const double topM = scaledRadiusM(kAtmosphereTopM);
    const double lengthM = std::sqrt(std::max(0.0, b * b + topM * topM - radiusM * radiusM)) - b;
    dvec4 sum(0.0);
    for (int i = 0; i < kSteps; ++i) {  // shorter steps where there is more air
        const double from = static_cast<double>(i) / kSteps, to = (i + 1.0) / kSteps;
        const double atM = lengthM * 0.25 * (from + to) * (from + to);
        const double r = std::sqrt(radiusM * radiusM + atM * (atM + 2.0 * b));
        const BentAir air = bentAirAt(r - raisedEarthRadiusM());
        sum += lengthM * (to * to - from * from) * dvec4(air.columns, air.bendingPerM * level / r);
    }
    return sum;
}

/// By altitude, finer near the ground.
double altitudeOfRow(double share) {
    return kAtmosphereTopM * share * share;
}
double shareOfAltitude(double altitudeM) {
    return std::sqrt(withinAir(altitudeM) / kAtmosphereTopM);
}

/// Sines of true elevations, finer near the horizon.
double upOfShare(double share, double lowest) {
    return lowest + (1.0 - lowest) * share * share;
}

struct SunTable {
    std::vector<dvec3> columnsM;
    std::vector<double> lowestUp;  ///< of each altitude
};

/// One altitude: from apparent elevations to true ones.
void fillRow(double altitudeM, std::span<dvec3> row, double& lowestUp) {
    const double lowest = std::asin(apparentHorizonUp(altitudeM));
    const auto last = static_cast<double>(row.size() - 1);
    std::vector<double> trueUps;
    std::vector<dvec3> columns;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const double share = static_cast<double>(i) / last;
        const double apparent = std::lerp(lowest, 0.5 * std::numbers::pi, share * share);
        const BentRay ray = bentRay(altitudeM, std::sin(apparent));
        trueUps.push_back(std::sin(apparent - ray.bending));
        columns.push_back(ray.columnsM);
    }
    lowestUp = trueUps.front();
    std::size_t below = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const double up = upOfShare(static_cast<double>(i) / last, lowestUp);
        while (below + 2 < trueUps.size() && trueUps[below + 1] < up) ++below;
        const double f = (up - trueUps[below]) / (trueUps[below + 1] - trueUps[below]);
        row[i] = glm::mix(columns[below], columns[below + 1], std::clamp(f, 0.0, 1.0));
    }
}

SunTable makeTable() {
    const auto width = static_cast<std::size_t>(kTableSize.x);
    const auto height = static_cast<std::size_t>(kTableSize.y);
    SunTable table{std::vector<dvec3>(width * height), std::vector<double>(height)};
    shareOut(height, workerCount(16), [&](std::size_t j, std::size_t, const Progress&) {
        const double share = static_cast<double>(j) / static_cast<double>(height - 1);
        fillRow(altitudeOfRow(share), std::span(table.columnsM).subspan(j * width, width),
                table.lowestUp[j]);
    });
    return table;
}

/// True less apparent sine, by the sine of the apparent elevation at sea level.
double trueLessApparent(double apparentUp) {
    const double apparentDeg = std::asin(apparentUp) / kRadPerDeg;
    const double atHorizonDeg = bentRay(0.0, 0.0).bending / kRadPerDeg;
    if (apparentUp >= 0.0) {
        return std::sin(apparentDeg * kRadPerDeg - bentRay(0.0, apparentUp).bending) - apparentUp;
    }
    const double scale = atHorizonDeg / refractionDeg(-atHorizonDeg);
    double low = apparentDeg - 1.0, high = apparentDeg;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (middle + scale * refractionDeg(middle) < apparentDeg ? low : high) = middle;
    }
    return std::sin(0.5 * (low + high) * kRadPerDeg) - apparentUp;
}

}  // namespace

double horizonUp(double altitudeM) {
    const double share = kEarthRadiusM / (kEarthRadiusM + std::max(altitudeM, 0.0));
    return -std::sqrt(std::max(0.0, 1.0 - share * share));
}

double apparentHorizonUp(double altitudeM) {
    const double share = raisedEarthRadiusM() / scaledRadiusM(std::max(altitudeM, 0.0));
    return -std::sqrt(std::max(0.0, 1.0 - share * share));
}

/// A ray that descends first is the whole of the level ray through its lowest point, without the
/// part that goes up beyond.
BentRay bentRay(double altitudeM, double up) {
    const double radiusM = scaledRadiusM(withinAir(altitudeM));
    if (up >= 0.0) {
        const dvec4 ray = upwards(radiusM, up);
        return {dvec3(ray), ray.w};
    }
    const double lowestM = std::max(raisedEarthRadiusM(), radiusM * std::sqrt(1.0 - up * up));
    const double within = std::sqrt(std::max(0.0, 1.0 - lowestM * lowestM / radiusM / radiusM));
    const dvec4 ray = 2.0 * upwards(lowestM, 0.0) - upwards(radiusM, within);
    return {dvec3(ray), ray.w};
}

double trueSunUp(double apparentUp) {
    constexpr int kCount = 1024;  // finer near the horizon, which is one of them
    static const std::vector<double> table = [] {
        std::vector<double> made;
        for (int i = 0; i <= kCount; ++i) {
            const double x = 2.0 * i / kCount - 1.0;
            made.push_back(trueLessApparent(std::copysign(x * x, x)));
        }
        return made;
    }();
    const double up = std::clamp(apparentUp, -1.0, 1.0);
    const double at = 0.5 * kCount * (1.0 + std::copysign(std::sqrt(std::abs(up)), up));
    const auto below = std::min(static_cast<std::size_t>(at), std::size_t{kCount - 1});
    return up + std::lerp(table[below], table[below + 1], at - static_cast<double>(below));
}

double apparentSunUp(double altitudeM, double trueUp) {
    const double truly = std::asin(std::clamp(trueUp, -1.0, 1.0));
    const double horizon = apparentHorizonUp(altitudeM);
    const double atHorizon = bentRay(altitudeM, horizon).bending;
    if (truly <= std::asin(horizon) - atHorizon) return std::sin(truly + atHorizon);
    double low = std::asin(horizon), high = 0.5 * std::numbers::pi;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (middle - bentRay(altitudeM, std::sin(middle)).bending < truly ? low : high) = middle;
    }
    return std::sin(0.5 * (low + high));
}

SunAir sunAir(double altitudeM, double trueUp) {
    static const SunTable table = makeTable();
    const double y = shareOfAltitude(altitudeM) * (kTableSize.y - 1);
    const auto j = std::min(static_cast<std::size_t>(y), table.lowestUp.size() - 2);
    const double fy = y - static_cast<double>(j);
    SunAir air;
    air.lowestUp = std::lerp(table.lowestUp[j], table.lowestUp[j + 1], fy);
    const double above = std::max(0.0, (trueUp - air.lowestUp) / (1.0 - air.lowestUp));
    const double x = std::sqrt(above) * (kTableSize.x - 1);
    const auto i = std::min(static_cast<std::size_t>(x), std::size_t{kTableSize.x - 2});
    const double fx = x - static_cast<double>(i);
    const dvec3* row = &table.columnsM[j * kTableSize.x + i];
    const dvec3* over = row + kTableSize.x;
    air.columnsM = glm::mix(glm::mix(row[0], row[1], fx), glm::mix(over[0], over[1], fx), fy);
    return air;
}

}  // namespace neph
