// hodograph.cpp: sums over the hodograph in steps of height.
#include "core/air/hodograph.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace neph {
namespace {

constexpr double kWindStepM = 100.0;

/// Heights of the hodograph's corners up to `topM`: those of the levels, and both ends.
std::vector<double> cornersOf(const Sounding& sounding, double topM) {
    std::vector<double> heights{0.0};
    for (const SoundingLevel& level : sounding.levels) {
        const double height = level.heightM - sounding.groundM;
        if (height > 0.0 && height < topM) heights.push_back(height);
    }
    heights.push_back(topM);
    return heights;
}

double pressureAt(const Sounding& sounding, double aboveGroundM) {
    const auto& levels = sounding.levels;
    const double height = sounding.groundM + aboveGroundM;
    const auto above = std::ranges::find_if(
        levels, [&](const SoundingLevel& level) { return level.heightM >= height; });
    if (above == levels.begin()) return levels.front().pressurePa;
    if (above == levels.end()) return levels.back().pressurePa;
    const SoundingLevel& below = *(above - 1);
    const double share = (height - below.heightM) / (above->heightM - below.heightM);
    return below.pressurePa * std::pow(above->pressurePa / below.pressurePa, share);
}

}  // namespace

glm::dvec2 bulkShearMPerS(const Sounding& sounding, double topM) {
    return windAt(sounding, topM) - windAt(sounding, 0.0);
}

glm::dvec2 meanWindMPerS(const Sounding& sounding, double fromM, double toM) {
    const int steps = std::max(1, static_cast<int>(std::ceil((toM - fromM) / kWindStepM)));
    glm::dvec2 sum(0.0);
    double weights = 0.0;
    for (int i = 0; i <= steps; ++i) {
        const double height = std::lerp(fromM, toM, static_cast<double>(i) / steps);
        const double weight = (i == 0 || i == steps ? 0.5 : 1.0) * pressureAt(sounding, height);
        sum += weight * windAt(sounding, height);
        weights += weight;
    }
    return sum / weights;
}

StormMotion stormMotionOf(const Sounding& sounding) {
    // [Bunkers00]: 7.5 m/s off the mean wind, across the shear between the lowest 500 m and 5.5 to
    // 6 km.
    constexpr double kDeviation = 7.5, kTopM = 6000.0, kLayerM = 500.0;
    StormMotion motion;
    motion.meanMPerS = meanWindMPerS(sounding, 0.0, kTopM);
    const glm::dvec2 shear =
        meanWindMPerS(sounding, kTopM - kLayerM, kTopM) - meanWindMPerS(sounding, 0.0, kLayerM);
    const double length = glm::length(shear);
    const glm::dvec2 right =
        length > 0.0 ? kDeviation * glm::dvec2(shear.y, -shear.x) / length : glm::dvec2(0.0);
    motion.rightMPerS = motion.meanMPerS + right;
    motion.leftMPerS = motion.meanMPerS - right;
    return motion;
}

double stormRelativeHelicity(const Sounding& sounding, double topM, glm::dvec2 motionMPerS) {
    const std::vector<double> corners = cornersOf(sounding, topM);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const glm::dvec2 a = windAt(sounding, corners[i]) - motionMPerS;
        const glm::dvec2 b = windAt(sounding, corners[i + 1]) - motionMPerS;
        sum += b.x * a.y - a.x * b.y;
    }
    return sum;
}

}  // namespace neph
