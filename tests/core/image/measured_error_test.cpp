// measured_error_test.cpp: what is said of an error that is known, and where it shows through
// noise.
#include "core/image/measured_error.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "core/base/error.h"

using namespace neph;

namespace {

constexpr int kFlatSide = 40;

ImageF flat(float grey) {
    ImageF image;
    image.size = {kFlatSide, kFlatSide};
    image.pixels.assign(kFlatSide * kFlatSide, glm::vec4(grey, grey, grey, 1.0f));
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
    CHECK(found.sizePx == glm::ivec2(kFlatSide, kFlatSide));
    CHECK(found.errors.bias == doctest::Approx(0.1).epsilon(0.2));
    CHECK(std::abs(found.errors.relRmse - 0.1) < 3.0 * found.errors.relRmseSigma);
    CHECK(found.errors.relRmseSigma > 0.01);
    CHECK_FALSE(isKnownWell(found));
    CHECK(isKnownWell(measureError(flat(1.1f), noisy(0.01f), 10000)));
}

TEST_CASE("One path in a thousand that is far too bright drowns no error, and no light is lost") {
    std::array<ImageF, 2> halves = noisy(0.2f);
    std::mt19937 random(5);
    std::uniform_int_distribution<std::size_t> anywhere(0, kFlatSide * kFlatSide - 1);
    constexpr int kRare = 1;
    constexpr double kBright = 40.0;
    for (ImageF& half : halves) {
        for (int i = 0; i < kRare; ++i) {
            half.pixels[anywhere(random)] +=
                glm::vec4(glm::vec3(static_cast<float>(kBright)), 0.0f);
        }
    }
    // Rare light is 40 in 1600 pixels of 1.
    const double level = 1.0 + kRare * kBright / (kFlatSide * kFlatSide);
    const MeasuredError found = measureError(flat(static_cast<float>(1.2 * level)), halves, 12);
    CHECK(found.errors.bias == doctest::Approx(0.2).epsilon(0.05));
    CHECK(imageErrors({flat(1.23f)}, {halves[0], halves.data(), &halves[1]}).relRmseSigma > 0.4);
    CHECK(found.errors.relRmseSigma < 0.1);
    CHECK(found.errors.relRmse == doctest::Approx(0.2).epsilon(0.15));
    CHECK(found.spread == doctest::Approx(1.0 - 1.0 / level).epsilon(0.1));
    CHECK(meaningOf(found).find("spread over the image") != std::string::npos);
}

TEST_CASE("An image that is much too dark where the light is has all of its error") {
    ImageF image = flat(0.2f);
    std::array<ImageF, 2> halves = noisy(0.1f);
    for (std::size_t i = 0; i < 400; ++i) {  // ten rows five times as bright
        for (ImageF& half : halves) half.pixels[i] *= glm::vec4(5.0f, 5.0f, 5.0f, 1.0f);
    }
    const MeasuredError found = measureError(image, halves, 12);
    // sqrt(1/4 (5-0.2)^2 + 3/4 (1-0.2)^2) / 2
    CHECK(found.errors.relRmse == doctest::Approx(1.2490).epsilon(0.02));
    CHECK(found.spread < 0.01);
}

TEST_CASE("A black image is all of its reference off") {
    const MeasuredError found = measureError(flat(0.0f), noisy(0.05f), 12);
    CHECK(found.errors.bias == doctest::Approx(-1.0));
    CHECK(found.errors.relRmse == doctest::Approx(1.0).epsilon(0.01));
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
            image.pixels[static_cast<std::size_t>(y * kFlatSide + x)] = {0.4f, 0.4f, 0.4f, 1.0f};
        }
    }
    const std::vector<float> errors = errorsBeyondNoise(image, noisy(0.1f));
    int inside = 0, outside = 0;
    for (int i = 0; i < kFlatSide * kFlatSide; ++i) {
        const int x = i % kFlatSide, y = i / kFlatSide;
        const int beyond = std::max(std::abs(2 * x - 29), std::abs(2 * y - 29));  // 9: on the edge
        const float error = errors[static_cast<std::size_t>(i)];
        inside += beyond <= 7 && error < -0.45f ? 1 : 0;
        outside += beyond >= 13 && error != 0.0f ? 1 : 0;
    }
    CHECK(inside == 64);
    CHECK(outside < 0.1 * 1456);  // 4.6 % of a normal distribution are beyond two deviations
}
