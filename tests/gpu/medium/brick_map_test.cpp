// brick_map_test.cpp: distances and bounds against plain loops over all bricks.
#include "app/render/medium/brick_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/gpu/context.h"

using namespace neph;
using namespace neph::render;

namespace {

/// Mostly nothing; what there is lies between 1e-8 and 1 per metre.
Array3f someBricks(glm::ivec3 count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> exponent(-8.0f, 0.0f);
    Array3f maxima(count);
    for (float& value : maxima.values) {
        if (random() % 30 == 0) value = std::pow(10.0f, exponent(random));
    }
    return maxima;
}

RegularGrid gridOf(glm::ivec3 voxels) {
    return {voxels, glm::dvec3(100.0, 200.0, 300.0), glm::dvec3(500.0, 400.0, 250.0)};
}

std::vector<std::uint8_t> distancesIn(const BrickMap& bricks) {
    const glm::ivec3 n = bricks.map.size();
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(n.x * n.y * n.z));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(bricks.map.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(texels.size()), texels.data());
    return texels;
}

template <typename Visit>
void forEach(glm::ivec3 count, Visit visit) {
    for (int z = 0; z < count.z; ++z)
        for (int y = 0; y < count.y; ++y)
            for (int x = 0; x < count.x; ++x) visit(glm::ivec3(x, y, z));
}

int chebyshev(glm::ivec3 a, glm::ivec3 b) {
    const glm::ivec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

}  // namespace

TEST_CASE("Every brick knows its distance to the nearest occupied one") {
    test::needContext();
    for (const glm::ivec3 voxels : {glm::ivec3(1), glm::ivec3(26, 41, 18), glm::ivec3(64, 7, 33)}) {
        for (unsigned seed = 0; seed < 4; ++seed) {
            const Array3f maxima = someBricks(brickCount(voxels), seed);
            const RegularGrid grid = gridOf(voxels);
            const double threshold = 2e-3 / glm::length(grid.extentM());
            const auto distances = distancesIn(mapBricks(maxima, grid, 2e-3));
            bool right = true;
            forEach(maxima.size, [&](glm::ivec3 p) {
                int nearest = 255;
                forEach(maxima.size, [&](glm::ivec3 q) {
                    if (static_cast<double>(maxima.at(q.x, q.y, q.z)) > threshold) {
                        nearest = std::min(nearest, chebyshev(p, q));
                    }
                });
                right = right && distances[maxima.index(p.x, p.y, p.z)] == nearest;
            });
            CHECK(right);
        }
    }
}

TEST_CASE("A distance that a byte cannot hold is given as the largest that it can") {
    test::needContext();
    const glm::ivec3 voxels{300 * kBrickVoxels, 1, 1};
    Array3f maxima(brickCount(voxels));
    maxima.values[0] = 1.0f;
    const auto distances = distancesIn(mapBricks(maxima, gridOf(voxels), 2e-3));
    CHECK(distances[254] == 254);
    CHECK(distances[299] == 255);
}

TEST_CASE("The occupied box holds every occupied brick and ends at the grid") {
    test::needContext();
    const glm::ivec3 voxels{26, 41, 18};
    Array3f maxima(brickCount(voxels));
    maxima.at(2, 3, 1) = 1e-3f;
    maxima.at(6, 5, 4) = 1e-3f;
    maxima.at(0, 0, 0) = 1e-12f;  // nobody sees it
    const glm::dvec3 brickM = static_cast<double>(kBrickVoxels) * glm::dvec3(500.0, 400.0, 250.0);
    const BrickMap bricks = mapBricks(maxima, gridOf(voxels), 2e-3);
    CHECK_FALSE(bricks.empty());
    CHECK((bricks.occupied.lowerM == glm::dvec3(2.0, 3.0, 1.0) * brickM));
    // The last brick in x and in z is cut by the end of the grid.
    CHECK((bricks.occupied.upperM == glm::dvec3(26 * 500.0, 6.0 * brickM.y, 18 * 250.0)));
    CHECK((bricks.brickM == brickM));
    maxima = Array3f(brickCount(voxels));
    CHECK(mapBricks(maxima, gridOf(voxels), 2e-3).empty());
}
