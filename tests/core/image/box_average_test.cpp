// box_average_test.cpp: means over areas, whole and in tiles.
#include "core/image/box_average.h"

#include <doctest/doctest.h>

#include <random>

using namespace neph;

namespace {

ImageF image(glm::ivec2 size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0f, 2.0f);
    ImageF made;
    made.size = size;
    for (int i = 0; i < size.x * size.y; ++i) {
        made.pixels.emplace_back(value(random), value(random), value(random), value(random));
    }
    return made;
}

ImageF cut(const ImageF& whole, glm::ivec2 at, glm::ivec2 size) {
    ImageF tile;
    tile.size = size;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            tile.pixels.push_back(
                whole.pixels[static_cast<std::size_t>((at.y + y) * whole.size.x + at.x + x)]);
        }
    }
    return tile;
}

}  // namespace

TEST_CASE("Pixels that cover whole ones are their means, and a border is shared by area") {
    ImageF row;
    row.size = {3, 1};
    row.pixels = {glm::vec4(1.0f), glm::vec4(2.0f), glm::vec4(6.0f)};
    BoxAverage average({3, 1}, {2, 1});
    average.add(row);
    const ImageF two = average.mean();
    REQUIRE(two.size == glm::ivec2(2, 1));
    CHECK(two.pixels[0].r == doctest::Approx((1.0 + 0.5 * 2.0) / 1.5));
    CHECK(two.pixels[1].a == doctest::Approx((0.5 * 2.0 + 6.0) / 1.5));
}

TEST_CASE("An average keeps the mean of the image, and of the same size it is the image") {
    const ImageF whole = image({37, 23}, 1);
    glm::dvec4 before(0.0), after(0.0);
    for (const glm::vec4& pixel : whole.pixels) before += glm::dvec4(pixel) / (37.0 * 23.0);
    BoxAverage average(whole.size, {10, 7});
    average.add(whole);
    for (const glm::vec4& pixel : average.mean().pixels) after += glm::dvec4(pixel) / 70.0;
    for (int c = 0; c < 4; ++c) CHECK(after[c] == doctest::Approx(before[c]).epsilon(1e-6));
    BoxAverage same(whole.size, whole.size);
    same.add(whole);
    CHECK(same.mean().pixels == whole.pixels);
}

TEST_CASE("Tiles in any order average as the whole image does") {
    const ImageF whole = image({20, 12}, 2);
    BoxAverage once({20, 12}, {7, 5}), tiled({20, 12}, {7, 5});
    once.add(whole);
    for (const glm::ivec2 at : {glm::ivec2(9, 5), {0, 0}, {9, 0}, {0, 5}}) {
        const glm::ivec2 size(at.x == 0 ? 9 : 11, at.y == 0 ? 5 : 7);
        tiled.add(cut(whole, at, size), at);
    }
    for (std::size_t i = 0; i < 35; ++i) {
        CHECK(tiled.mean().pixels[i].g == doctest::Approx(once.mean().pixels[i].g).epsilon(1e-6));
    }
}

TEST_CASE("A coarser size has the shape of the image and is never larger or empty") {
    CHECK(coarserSize({1280, 720}, 64 * 36) == glm::ivec2(64, 36));
    CHECK(coarserSize({16, 9}, 64 * 36) == glm::ivec2(16, 9));
    CHECK(coarserSize({60000, 2}, 100) == glm::ivec2(1732, 1));
}
