// measured_error_test.cpp: what is said of an error that is known, and where it shows through
// noise.
#include "core/image/measured_error.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "core/base/error.h"

using namespace neph;

namespace {

constexpr int kSide = 40;

ImageF flat(float grey) {
    ImageF image;
    image.size = {kSide, kSide};
    image.pixels.assign(kSide * kSide, glm::vec4(grey, grey, grey, 1.0f));
    return image;
}

/// Two halves of an image of 1 whose mean has grey noise of this deviation.
std::array<ImageF, 2> noisy(float deviation) {
    std::mt19937 random(3);
    std::normal_distribution<float> noise(0.0f, deviation * std::sqrt(2.0f));
    std::array<ImageF, 2> halves{flat(1.0f), flat(1.0f)};
    for (ImageF& half : halves) {
        for (glm::vec4& pixel : half.pixels) pixel += glm::vec4(glm::vec3(noise(random)), 0.0f);
    }
    return halves;
}

MeasuredError measured(double relRmse, double sigma, double bias, double biasSigma) {
    MeasuredError made;
    made.errors.relRmse = relRmse;
    made.errors.relRmseSigma = sigma;
    made.errors.bias = bias;
    made.errors.biasSigma = biasSigma;
    made.sizePx = {64, 36};
    made.paths = 26;
    return made;
}

}  // namespace

TEST_CASE("An image a tenth too bright has that error and bias below noise of a third") {
    const MeasuredError found = measureError(flat(1.1f), noisy(0.3f), 12);
    CHECK(found.paths == 12);
    CHECK(found.sizePx == glm::ivec2(kSide, kSide));
    CHECK(found.errors.bias == doctest::Approx(0.1).epsilon(0.2));
    CHECK(std::abs(found.errors.relRmse - 0.1) < 3.0 * found.errors.relRmseSigma);
    CHECK(found.errors.relRmseSigma > 0.01);
    CHECK_FALSE(isKnownWell(found));
    CHECK(isKnownWell(measureError(flat(1.1f), noisy(0.01f), 10000)));
}

TEST_CASE("A black reference is refused, and halves of another size are") {
    CHECK_THROWS_AS(measureError(flat(1.0f), {flat(0.0f), flat(0.0f)}, 4), Error);
    ImageF small;
    small.size = {1, 1};
    small.pixels = {glm::vec4(1.0f)};
    CHECK_THROWS_AS(measureError(small, noisy(0.1f), 4), Error);
}

TEST_CASE("An error is known well at a tenth of itself, or at 0.3 %") {
    CHECK(isKnownWell(measured(0.10, 0.0099, 0.0, 0.0)));
    CHECK_FALSE(isKnownWell(measured(0.10, 0.011, 0.0, 0.0)));
    CHECK(isKnownWell(measured(0.0, 0.003, 0.0, 0.0)));
}

TEST_CASE("An error in words has the digits that its standard error leaves it") {
    CHECK(errorText(measured(0.0312, 0.0041, -0.0018, 0.002)) == "3.1 % ± 0.4 (bias -0.2 %)");
    CHECK(errorText(measured(0.254, 0.023, 0.0449, 0.012)) == "25 % ± 2 (bias +4 %)");
    CHECK(errorText(measured(0.0, 0.0, 0.0, 0.0)) == "0.00 % ± 0.00 (bias +0.00 %)");
    const std::string meaning = meaningOf(measured(0.0312, 0.0041, -0.0018, 0.002));
    CHECK(meaning.find("64 x 36 px") != std::string::npos);
    CHECK(meaning.find("26 paths per pixel") != std::string::npos);
}

TEST_CASE("Where noise explains a difference there is none, and beyond it stands with its sign") {
    ImageF image = flat(1.0f);
    for (int y = 10; y < 20; ++y) {
        for (int x = 10; x < 20; ++x) {
            image.pixels[static_cast<std::size_t>(y * kSide + x)] = {0.4f, 0.4f, 0.4f, 1.0f};
        }
    }
    const std::vector<float> errors = errorsBeyondNoise(image, noisy(0.1f));
    int inside = 0, outside = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const int x = i % kSide, y = i / kSide;
        const bool dark = x >= 10 && x < 20 && y >= 10 && y < 20;
        const float error = errors[static_cast<std::size_t>(i)];
        inside += dark && error < -0.4f ? 1 : 0;
        outside += !dark && error != 0.0f ? 1 : 0;
    }
    CHECK(inside >= 97);
    CHECK(outside < 0.08 * 1500);  // 4.6 % of a normal distribution are beyond two deviations
}
