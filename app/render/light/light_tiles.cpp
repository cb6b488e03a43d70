// light_tiles.cpp: every block marks the tiles that its shadow on each slice touches.
#include "app/render/light/light_tiles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace neph::render {
namespace {

struct Span {
    int lo, hi;  ///< both within
};

Span clamped(double lo, double hi, int count) {
    return {static_cast<int>(std::clamp(std::floor(lo), 0.0, count - 1.0)),
            static_cast<int>(std::clamp(std::floor(hi), 0.0, count - 1.0))};
}

/// Tiles that a block covers along one axis of the light buffer.
Span tilesAcross(glm::dvec3 axis, double lowerM, double extentM, int texels, glm::dvec3 middleM,
                 glm::dvec3 blockM, int tiles) {
    const double perM = texels / extentM / kLightTile;
    const double at = glm::dot(axis, middleM) - lowerM;
    const double reach = 0.5 * glm::dot(glm::abs(axis), blockM);
    return clamped((at - reach) * perM, (at + reach) * perM, tiles);
}

}  // namespace

LightTiles tilesOf(const std::vector<glm::ivec3>& blocks, glm::dvec3 blockM, const SlicePlan& plan,
                   int firstSlice, int slices) {
    const glm::ivec2 count = (plan.lightSizePx + kLightTile - 1) / kLightTile;
    const auto perSlice = static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y);
    std::vector<std::uint8_t> marks(perSlice * static_cast<std::size_t>(slices), 0);
    const double reachM = 0.5 * glm::dot(glm::abs(plan.normal), blockM);
    for (const glm::ivec3 block : blocks) {
        const glm::dvec3 middleM = (glm::dvec3(block) + 0.5) * blockM;
        const double alongM = glm::dot(plan.normal, middleM) - plan.firstM;
        const double lo = std::ceil((alongM - reachM) / plan.spacingM - 0.5) - firstSlice;
        const double hi = std::floor((alongM + reachM) / plan.spacingM - 0.5) - firstSlice;
        if (hi < 0.0 || lo > slices - 1.0) continue;
        const Span u = tilesAcross(plan.lightU, plan.lightLowerM.x, plan.lightExtentM.x,
                                   plan.lightSizePx.x, middleM, blockM, count.x);
        const Span v = tilesAcross(plan.lightV, plan.lightLowerM.y, plan.lightExtentM.y,
                                   plan.lightSizePx.y, middleM, blockM, count.y);
        const Span k = clamped(lo, hi, slices);
        for (int slice = k.lo; slice <= k.hi; ++slice)
            for (int y = v.lo; y <= v.hi; ++y)
                for (int x = u.lo; x <= u.hi; ++x)
                    marks[perSlice * static_cast<std::size_t>(slice) +
                          static_cast<std::size_t>(y * count.x + x)] = 1;
    }
    LightTiles out;
    out.firstOf.push_back(0);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const int place = static_cast<int>(i % perSlice);
        if (marks[i] != 0) out.tiles.emplace_back(place % count.x, place / count.x);
        if (i % perSlice == perSlice - 1) out.firstOf.push_back(static_cast<int>(out.tiles.size()));
    }
    return out;
}

}  // namespace neph::render
