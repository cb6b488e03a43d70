// noise_test.cpp: the baked tiles.
#include "core/optics/noise.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "shaders/lib/glsl_cpp.h"

using namespace neph;

TEST_CASE("A baked tile holds the shader library's noise at voxel centres, with its mean") {
    const Array3f billow = bakeNoise(NoiseCharacter::billow, 32);
    const Array3f wisp = bakeNoise(NoiseCharacter::wisp, 32);
    REQUIRE(billow.size == glm::ivec3(32));
    CHECK(billow.at(3, 17, 30) == glsl::billow(glm::vec3(3.5f, 17.5f, 30.5f) / 32.0f));
    CHECK(wisp.at(31, 0, 9) == glsl::wisp(glm::vec3(31.5f, 0.5f, 9.5f) / 32.0f));
    for (const Array3f* tile : {&billow, &wisp}) {
        double mean = 0.0;
        for (float v : tile->values)
            mean += static_cast<double>(v) / static_cast<double>(tile->values.size());
        CHECK(std::abs(mean - static_cast<double>(glsl::kDetailMean)) < 0.02);
    }
}

TEST_CASE("A baked tile meets itself at its edges without a seam") {
    for (NoiseCharacter character : {NoiseCharacter::billow, NoiseCharacter::wisp}) {
        const Array3f tile = bakeNoise(character, 64);
        double seam = 0.0, inside = 0.0;
        for (int b = 0; b < 64; ++b) {
            for (int a = 0; a < 64; ++a) {
                auto step = [&](int from, int to) {
                    return static_cast<double>(std::abs(tile.at(a, from, b) - tile.at(a, to, b)) +
                                               std::abs(tile.at(from, a, b) - tile.at(to, a, b)) +
                                               std::abs(tile.at(a, b, from) - tile.at(a, b, to)));
                };
                seam += step(63, 0);
                inside += 0.5 * (step(20, 21) + step(45, 46));
            }
        }
        CHECK(seam < 1.5 * inside);
    }
}
