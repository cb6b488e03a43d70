// light_tiles.cpp: every block marks the tiles that its shadow on each slice touches.
#include "app/render/light/light_tiles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

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

/// Which tiles lie along one axis of a buffer that repeats between two of its texels, in order of
/// no consequence.
std::vector<int> repeatedTiles(double lo, double hi, int texels) {
    const int tiles = (texels + kLightTile - 1) / kLightTile;
    const auto first = static_cast<std::int64_t>(std::floor(lo));
    const auto length = static_cast<std::int64_t>(std::floor(hi)) - first;
    std::vector<std::uint8_t> marks(static_cast<std::size_t>(tiles), 0);
    std::vector<int> found;
    for (std::int64_t i = 0; i <= std::min<std::int64_t>(length, texels - 1); ++i) {
        const auto tile = static_cast<int>(((first + i) % texels + texels) % texels) / kLightTile;
        if (std::exchange(marks[static_cast<std::size_t>(tile)], std::uint8_t{1}) == 0) {
            found.push_back(tile);
        }
    }
    return found;
}

/// Of a block cut by a level slice.
std::vector<int> repeatedTilesAcross(const SlicePlan& plan, int axis, glm::dvec3 middleM,
                                     glm::dvec3 blockM, double heightM) {
    const glm::dvec3 across = axis == 0 ? plan.lightU : plan.lightV;
    const double texelsPerM = plan.lightSizePx[axis] / plan.lightExtentM[axis];
    const double shiftM = across.z * heightM - plan.lightLowerM[axis];
    // The domain ends within a block, and begins again there.
    const double upperM = std::min(middleM[axis] + 0.5 * blockM[axis], plan.lightExtentM[axis]);
    const double lowerM = middleM[axis] - 0.5 * blockM[axis];
    return repeatedTiles((lowerM + shiftM) * texelsPerM, (upperM + shiftM) * texelsPerM,
                         plan.lightSizePx[axis]);
}

}  // namespace

LightTiles tilesOf(const std::vector<glm::ivec3>& blocks, glm::dvec3 blockM, const SlicePlan& plan,
                   int firstSlice, int slices) {
    const glm::ivec2 count = (plan.lightSizePx + kLightTile - 1) / kLightTile;
    const auto perSlice = static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y);
    std::vector<std::uint8_t> marks(perSlice * static_cast<std::size_t>(slices), 0);
    const auto mark = [&](int slice, int x, int y) {
        marks[perSlice * static_cast<std::size_t>(slice) +
              static_cast<std::size_t>(y * count.x + x)] = 1;
    };
    const double reachM = 0.5 * glm::dot(glm::abs(plan.normal), blockM);
    for (const glm::ivec3 block : blocks) {
        const glm::dvec3 middleM = (glm::dvec3(block) + 0.5) * blockM;
        const double alongM = glm::dot(plan.normal, middleM) - plan.firstM;
        const double lo = std::ceil((alongM - reachM) / plan.spacingM - 0.5) - firstSlice;
        const double hi = std::floor((alongM + reachM) / plan.spacingM - 0.5) - firstSlice;
        if (hi < 0.0 || lo > slices - 1.0) continue;
        const Span k = clamped(lo, hi, slices);
        if (plan.repeats) {
            for (int slice = k.lo; slice <= k.hi; ++slice) {
                const double planeM = plan.firstM + (firstSlice + slice + 0.5) * plan.spacingM;
                const double heightM = planeM / plan.normal.z;
                const auto xs = repeatedTilesAcross(plan, 0, middleM, blockM, heightM);
                for (const int y : repeatedTilesAcross(plan, 1, middleM, blockM, heightM))
                    for (const int x : xs) mark(slice, x, y);
            }
            continue;
        }
        const Span u = tilesAcross(plan.lightU, plan.lightLowerM.x, plan.lightExtentM.x,
                                   plan.lightSizePx.x, middleM, blockM, count.x);
        const Span v = tilesAcross(plan.lightV, plan.lightLowerM.y, plan.lightExtentM.y,
                                   plan.lightSizePx.y, middleM, blockM, count.y);
        for (int slice = k.lo; slice <= k.hi; ++slice)
            for (int y = v.lo; y <= v.hi; ++y)
                for (int x = u.lo; x <= u.hi; ++x) mark(slice, x, y);
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
