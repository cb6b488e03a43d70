// air_columns.cpp: a table over altitude and direction, as [Bruneton17] lays it out, of columns
// that do not depend on how dense the air is.
#include "core/sky/air_columns.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/sky/atmosphere.h"

namespace neph {
namespace {

using glm::dvec2, glm::dvec3;

constexpr double kOzoneMiddleM = 25e3, kOzoneHalfM = 15e3;  // a tent. [Bruneton17]
constexpr glm::ivec2 kTableSize{256, 128};                  // directions, altitudes
constexpr double kTopRadiusM = kEarthRadiusM + kAtmosphereTopM;
/// From the horizon on the ground to the top.
const double kHorizonToTopM = std::sqrt(kTopRadiusM * kTopRadiusM - kEarthRadiusM * kEarthRadiusM);

/// Up from where it is, or level.
dvec3 columnsUpM(double radiusM, double up) {
    constexpr int kSteps = 64;
    const double b = radiusM * up;
    const double lengthM =
        std::sqrt(std::max(0.0, b * b + kTopRadiusM * kTopRadiusM - radiusM * radiusM)) - b;
    dvec3 sum(0.0);
    for (int i = 0; i < kSteps; ++i) {  // shorter steps where there is more air
        const double from = static_cast<double>(i) / kSteps, to = (i + 1.0) / kSteps;
        const double atM = lengthM * 0.25 * (from + to) * (from + to);
        const double altitudeM =
            std::sqrt(radiusM * radiusM + atM * (atM + 2.0 * b)) - kEarthRadiusM;
        sum += lengthM * (to * to - from * from) * airDensity(altitudeM);
    }
    return sum;
}

/// What a place in the table stands for: how far it is to the horizon, between the ground and the
/// top; and how far to the top along the ray, between the least and the most there is.
struct Place {
    double toHorizonM, leastM, mostM;
    explicit Place(double radiusM)
        : toHorizonM(std::sqrt(std::max(0.0, radiusM * radiusM - kEarthRadiusM * kEarthRadiusM))),
          leastM(kTopRadiusM - radiusM),
          mostM(toHorizonM + kHorizonToTopM) {}
};

double radiusOf(double altitudeM) {
    return kEarthRadiusM + std::clamp(altitudeM, 0.0, kAtmosphereTopM);
}

void fillRow(std::span<dvec3> row, double toHorizonM) {
    const double radiusM = std::sqrt(toHorizonM * toHorizonM + kEarthRadiusM * kEarthRadiusM);
    const Place place(radiusM);
    const double topM2 = kHorizonToTopM * kHorizonToTopM - toHorizonM * toHorizonM;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(row.size() - 1);
        const double toTopM = std::lerp(place.leastM, place.mostM, share);
        const double up = toTopM > 0.0 ? (topM2 - toTopM * toTopM) / (2.0 * radiusM * toTopM) : 1.0;
        row[i] = integratedColumnsM(radiusM - kEarthRadiusM, std::clamp(up, -1.0, 1.0));
    }
}

std::vector<dvec3> makeTable() {
    const auto width = static_cast<std::size_t>(kTableSize.x);
    const auto height = static_cast<std::size_t>(kTableSize.y);
    std::vector<dvec3> table(width * height);
    shareOut(height, workerCount(16), [&](std::size_t j, std::size_t, const Progress&) {
        const double share = static_cast<double>(j) / static_cast<double>(height - 1);
        fillRow(std::span(table).subspan(j * width, width), kHorizonToTopM * share);
    });
    return table;
}

dvec3 exactDensity(double altitudeM) {
    return {std::exp(-altitudeM / kMoleculesHeightM), std::exp(-altitudeM / kHazeHeightM),
            std::max(0.0, 1.0 - std::abs(altitudeM - kOzoneMiddleM) / kOzoneHalfM)};
}

}  // namespace

/// Exponentials take long; between so many altitudes they are linear within a thousandth.
dvec3 airDensity(double altitudeM) {
    constexpr std::size_t kLayers = 1000;
    constexpr double kLayerM = kAtmosphereTopM / kLayers;
    static const std::vector<dvec3> layers = [] {
        std::vector<dvec3> made;
        for (std::size_t i = 0; i <= kLayers + 1; ++i) {
            made.push_back(exactDensity(kLayerM * static_cast<double>(i)));
        }
        return made;
    }();
    const double at = std::clamp(altitudeM, 0.0, kAtmosphereTopM) / kLayerM;
    const auto i = static_cast<std::size_t>(at);
    return glm::mix(layers[i], layers[i + 1], at - static_cast<double>(i));
}

double horizonUp(double altitudeM) {
    const double share = kEarthRadiusM / (kEarthRadiusM + std::max(altitudeM, 0.0));
    return -std::sqrt(std::max(0.0, 1.0 - share * share));
}

/// A ray that descends first is the whole of the level ray through its lowest point, without the
/// part that goes up beyond.
dvec3 integratedColumnsM(double altitudeM, double up) {
    const double radiusM = radiusOf(altitudeM);
    if (up >= 0.0) return columnsUpM(radiusM, up);
    const double lowestM = std::max(kEarthRadiusM, radiusM * std::sqrt(1.0 - up * up));
    return 2.0 * columnsUpM(lowestM, 0.0) - columnsUpM(radiusM, -up);
}

dvec3 airColumnsM(double altitudeM, double up) {
    static const std::vector<dvec3> table = makeTable();
    const double radiusM = radiusOf(altitudeM);
    const Place place(radiusM);
    const double b = radiusM * std::clamp(up, horizonUp(altitudeM), 1.0);
    const double toTopM =
        std::sqrt(std::max(0.0, b * b + kTopRadiusM * kTopRadiusM - radiusM * radiusM)) - b;
    const dvec2 share{(toTopM - place.leastM) / std::max(place.mostM - place.leastM, 1.0),
                      place.toHorizonM / kHorizonToTopM};
    const dvec2 at = glm::clamp(share, 0.0, 1.0) * dvec2(kTableSize - 1);
    const glm::ivec2 cell = glm::min(glm::ivec2(at), kTableSize - 2);
    const dvec2 f = at - dvec2(cell);
    const dvec3* row = &table[static_cast<std::size_t>(cell.y * kTableSize.x + cell.x)];
    const dvec3* above = row + kTableSize.x;
    return glm::mix(glm::mix(row[0], row[1], f.x), glm::mix(above[0], above[1], f.x), f.y);
}

}  // namespace neph
