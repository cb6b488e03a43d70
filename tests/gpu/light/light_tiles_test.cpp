// light_tiles_test.cpp: tiles against every texel of every slice, one by one.
#include "app/render/light/light_tiles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "core/look/look.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::render;

namespace {

using Tile = std::tuple<int, int, int>;  // slice, x, y

constexpr glm::ivec3 kBlocks{5, 4, 3};
constexpr glm::dvec3 kBlockM{4000.0, 4000.0, 3000.0};

BoxM box() {
    return {glm::dvec3(0.0), glm::dvec3(kBlocks) * kBlockM - 700.0};  // a grid ends within a block
}

std::vector<glm::ivec3> someBlocks(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<glm::ivec3> blocks;
    for (int z = 0; z < kBlocks.z; ++z)
        for (int y = 0; y < kBlocks.y; ++y)
            for (int x = 0; x < kBlocks.x; ++x)
                if (random() % 8 == 0) blocks.emplace_back(x, y, z);
    return blocks;
}

std::set<Tile> marked(const LightTiles& tiles, int firstSlice) {
    std::set<Tile> found;
    for (std::size_t slice = 0; slice + 1 < tiles.firstOf.size(); ++slice) {
        for (int i = tiles.firstOf[slice]; i < tiles.firstOf[slice + 1]; ++i) {
            const glm::ivec2 tile = tiles.tiles[static_cast<std::size_t>(i)];
            found.emplace(firstSlice + static_cast<int>(slice), tile.x, tile.y);
        }
    }
    return found;
}

/// Tiles of the texels whose middle lies in a block.
std::set<Tile> needed(const std::vector<glm::ivec3>& blocks, const SlicePlan& plan,
                      glm::dvec3 towardsSun) {
    std::set<Tile> found;
    for (int slice = 0; slice < plan.count; ++slice) {
        const double planeM = plan.firstM + (slice + 0.5) * plan.spacingM;
        for (int y = 0; y < plan.lightSizePx.y; ++y)
            for (int x = 0; x < plan.lightSizePx.x; ++x) {
                const glm::dvec2 across = plan.lightLowerM + (glm::dvec2(x, y) + 0.5) /
                                                                 glm::dvec2(plan.lightSizePx) *
                                                                 plan.lightExtentM;
                const glm::dvec3 base = plan.repeats
                                            ? glm::dvec3(across, 0.0)
                                            : plan.lightU * across.x + plan.lightV * across.y;
                glm::dvec3 p = base + towardsSun * ((planeM - glm::dot(plan.normal, base)) /
                                                    glm::dot(plan.normal, towardsSun));
                if (plan.repeats) {
                    for (int axis = 0; axis < 2; ++axis) {
                        const double widthM = plan.lightExtentM[axis];
                        p[axis] -= widthM * std::floor(p[axis] / widthM);
                    }
                }
                const glm::ivec3 block(glm::floor(p / kBlockM));
                if (std::find(blocks.begin(), blocks.end(), block) == blocks.end()) continue;
                found.emplace(slice, x / kLightTile, y / kLightTile);
            }
    }
    return found;
}

LightTiles all(const std::vector<glm::ivec3>& blocks, const SlicePlan& plan) {
    return tilesOf(blocks, kBlockM, plan, 0, plan.count);
}

void check(const std::vector<glm::ivec3>& blocks, const SlicePlan& plan, glm::dvec3 towardsSun) {
    const std::set<Tile> has = marked(all(blocks, plan), 0),
                         needs = needed(blocks, plan, towardsSun);
    CHECK(std::includes(has.begin(), has.end(), needs.begin(), needs.end()));
    CHECK(needs.size() > 0);
    const glm::ivec2 tiles = (plan.lightSizePx + kLightTile - 1) / kLightTile;
    CHECK(static_cast<int>(has.size()) < tiles.x * tiles.y * plan.count);
    std::set<Tile> inBatches;
    for (int first = 0; first < plan.count; first += 7) {
        inBatches.merge(
            marked(tilesOf(blocks, kBlockM, plan, first, std::min(7, plan.count - first)), first));
    }
    CHECK((inBatches == has));
}

}  // namespace

TEST_CASE("Every texel of a slice that lies in a block is in a tile, from any sun") {
    for (const float elevation : {0.0f, 7.0f, 35.0f, 61.0f, 90.0f}) {
        for (const float azimuth : {0.0f, 45.0f, 131.0f, 225.0f, 300.0f}) {
            CAPTURE(elevation);
            CAPTURE(azimuth);
            const glm::dvec3 sun = compassDirWorld(azimuth, elevation);
            const auto blocks = someBlocks(static_cast<unsigned>(azimuth + elevation));
            check(blocks, planSunSlices(sun, box(), 300.0), sun);
        }
    }
}

TEST_CASE("Every texel of a level slice that lies in a block is in a tile, from any sun") {
    for (const float elevation : {-20.0f, -1.0f, 7.0f, 35.0f, 90.0f}) {
        for (const float azimuth : {0.0f, 131.0f, 300.0f}) {
            CAPTURE(elevation);
            CAPTURE(azimuth);
            const glm::dvec3 sun = compassDirWorld(azimuth, elevation);
            const auto blocks = someBlocks(static_cast<unsigned>(azimuth + 90.0f));
            const SlicePlan plan = planRepeatedSlices(sun, box(), box().upperM, 600.0);
            CHECK(plan.lightStepM <= 600.0 * 1.001);
            check(blocks, plan, sun);
        }
    }
}

TEST_CASE("Every texel of a slice that lies in a block is in a tile, from any camera") {
    const RegularGrid grid{kBlocks, glm::dvec3(0.0), kBlockM};
    const glm::dvec3 sun = compassDirWorld(225.0f, 40.0f);
    for (const test::View& view : test::views()) {
        CAPTURE(view.name);
        const Camera camera = placeCamera(view.pose, grid, 1.5);
        check(someBlocks(5), planSlices(camera, sun, box(), 40, 300.0), sun);
    }
}

TEST_CASE("Where there is no block there are no tiles") {
    const glm::dvec3 sun = compassDirWorld(225.0f, 40.0f);
    const SlicePlan plan = planSunSlices(sun, box(), 300.0);
    const LightTiles none = all({}, plan);
    CHECK(none.tiles.empty());
    CHECK(none.firstOf == std::vector<int>(static_cast<std::size_t>(plan.count) + 1, 0));
}
