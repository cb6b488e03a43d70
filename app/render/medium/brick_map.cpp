// brick_map.cpp: distances and bounds, on the CPU: there are few bricks.
#include "app/render/medium/brick_map.h"

#include <algorithm>
#include <cstdint>

namespace neph::render {
namespace {

using Bytes = Array3<std::uint8_t>;

BoxM boundsOf(const Bytes& distance, glm::dvec3 brickM, glm::dvec3 extentM) {
    glm::ivec3 lower = distance.size, upper{0};
    for (int z = 0; z < distance.size.z; ++z)
        for (int y = 0; y < distance.size.y; ++y)
            for (int x = 0; x < distance.size.x; ++x) {
                if (distance.at(x, y, z) != 0) continue;
                lower = glm::min(lower, glm::ivec3(x, y, z));
                upper = glm::max(upper, glm::ivec3(x, y, z) + 1);
            }
    if (upper == glm::ivec3(0)) return {};
    return {glm::dvec3(lower) * brickM, glm::min(glm::dvec3(upper) * brickM, extentM)};
}

}  // namespace

// By a forward and a backward sweep over the 13 earlier neighbours.
Array3<std::uint8_t> emptyDistances(const Array3f& bricks, float threshold) {
    constexpr std::uint8_t kFar = 255;
    Bytes distance(bricks.size, kFar);
    const glm::ivec3 n = bricks.size;
    for (std::size_t i = 0; i < bricks.values.size(); ++i) {
        if (bricks.values[i] > threshold) distance.values[i] = 0;
    }
    const auto relax = [&](glm::ivec3 p, int sign) {
        std::uint8_t& here = distance.at(p.x, p.y, p.z);
        for (int k = 0; k < 13; ++k) {
            const glm::ivec3 q = p - sign * glm::ivec3(1 - k % 3, 1 - k / 3 % 3, 1 - k / 9);
            if (glm::any(glm::lessThan(q, glm::ivec3(0))) ||
                glm::any(glm::greaterThanEqual(q, n))) {
                continue;
            }
            here = std::min<std::uint8_t>(here, static_cast<std::uint8_t>(std::min<int>(
                                                    distance.at(q.x, q.y, q.z) + 1, kFar)));
        }
    };
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x) relax({x, y, z}, 1);
    for (int z = n.z - 1; z >= 0; --z)
        for (int y = n.y - 1; y >= 0; --y)
            for (int x = n.x - 1; x >= 0; --x) relax({x, y, z}, -1);
    return distance;
}

BrickMap mapBricks(const Array3f& maximumPerM, const RegularGrid& grid, double invisibleDepth) {
    const double diagonalM = glm::length(grid.extentM());
    const Bytes distance =
        emptyDistances(maximumPerM, static_cast<float>(invisibleDepth / diagonalM));
    BrickMap bricks;
    bricks.brickM = grid.spacingM * static_cast<double>(kBrickVoxels);
    bricks.occupied = boundsOf(distance, bricks.brickM, grid.extentM());
    bricks.map = gl::Texture::make3D(GL_R8UI, distance.size);
    bricks.map.upload(GL_RED_INTEGER, GL_UNSIGNED_BYTE, distance.values.data());
    return bricks;
}

Array3f readBack(const gl::Texture& texture) {
    Array3f values(texture.size());
    glGetTextureImage(texture.name(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(values.values.size() * sizeof(float)),
                      values.values.data());
    return values;
}

}  // namespace neph::render
