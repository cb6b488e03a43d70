// error_image_test.cpp: colours of errors, the end of the scale, and the legend's place.
#include "core/image/error_image.h"

#include <doctest/doctest.h>

#include <set>
#include <vector>

using namespace neph;

namespace {

glm::ivec3 pixelAt(const Image8& image, int x, int y) {
    const auto at = static_cast<std::size_t>(4 * (y * image.size.x + x));
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

}  // namespace

TEST_CASE("Magnitudes go from black to pale yellow, signed errors from blue over grey to red") {
    const ErrorScale plain{0.5}, twoSided{0.5, true};
    const auto bytes = [](double error, const ErrorScale& scale) {
        return glm::ivec3(errorColour(error, scale) * 255.0f + 0.5f);
    };
    CHECK(bytes(0.0, plain) == glm::ivec3(0, 0, 4));  // magma's first and last of 256
    CHECK(bytes(0.5, plain) == glm::ivec3(252, 253, 191));
    CHECK(bytes(-0.5, plain) == bytes(0.5, plain));
    CHECK(bytes(9.0, plain) == bytes(0.5, plain));
    CHECK(bytes(-0.5, twoSided) == glm::ivec3(59, 76, 192));  // [Moreland09]
    CHECK(bytes(0.0, twoSided) == glm::ivec3(221, 221, 221));
    CHECK(bytes(0.5, twoSided) == glm::ivec3(180, 4, 38));
}

TEST_CASE("More error is never darker") {
    const auto light = [](double error) {
        const glm::vec3 c = errorColour(error, {1.0});
        return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
    };
    for (int i = 0; i < 100; ++i) CHECK(light(0.01 * (i + 1)) > light(0.01 * i));
}

TEST_CASE("The scale ends at 1, 2 or 5 times a power of ten that holds 99 % of the errors") {
    std::vector<float> errors(1000, 0.03f);
    CHECK(roundEnd(errors) == doctest::Approx(0.05));
    errors[0] = -40.0f;  // one in a thousand may be beyond
    CHECK(roundEnd(errors) == doctest::Approx(0.05));
    for (std::size_t i = 0; i < 20; ++i) errors[i] = -0.7f;
    CHECK(roundEnd(errors) == doctest::Approx(1.0));
    CHECK(roundEnd(std::vector<float>{0.0f}) == doctest::Approx(1e-3));
}

TEST_CASE("The image of errors is on top, with a legend below that shows every colour") {
    const glm::ivec2 size(300, 3);
    std::vector<float> errors(900, 0.0f);
    errors[301] = 1.0f;  // second row
    const ErrorScale scale{1.0, true, true, "(A-B)/B"};
    const Image8 image = errorImage(size, errors, scale);
    CHECK(image.size.x == 300);
    CHECK(image.size.y > 3);
    CHECK(image.rgba.size() == static_cast<std::size_t>(4 * image.size.x * image.size.y));
    CHECK(pixelAt(image, 1, 1) == glm::ivec3(180, 4, 38));
    CHECK(pixelAt(image, 2, 1) == glm::ivec3(221, 221, 221));
    std::set<int> blues;
    for (int x = 0; x < image.size.x; ++x) blues.insert(pixelAt(image, x, 3 + 6).b);
    CHECK(blues.size() > 60);  // a bar from one end of the map to the other
    CHECK(errorImage({2, 2}, std::vector<float>(4, 0.0f), scale).size.x >= 200);
}
