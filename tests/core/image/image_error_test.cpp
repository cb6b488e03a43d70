// image_error_test.cpp: errors of images whose truth is known.
#include "core/image/image_error.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/base/error.h"

using namespace neph;

namespace {

ImageF grey(std::vector<float> values) {
    ImageF image;
    image.size = {static_cast<int>(values.size()), 1};
    for (const float value : values) image.pixels.emplace_back(value, value, value, 1.0f);
    return image;
}

constexpr int kSide = 64;

/// From 0.2 to 1.8 over the image: mean 1, standard deviation 1.6/√12.
ImageF ramp(float factor = 1.0f) {
    ImageF image;
    image.size = {kSide, kSide};
    for (int i = 0; i < kSide * kSide; ++i) {
        const float value = 0.2f + 1.6f * (static_cast<float>(i) + 0.5f) / (kSide * kSide);
        image.pixels.emplace_back(glm::vec3(factor * value), 1.0f);
    }
    return image;
}

/// √mean truth² of the ramp, whose mean is 1.
const double kRampRms = std::sqrt(1.0 + 1.6 * 1.6 / 12.0);

struct Halves {
    ImageF image, a, b;
    SampledImage sampled() const { return {image, &a, &b}; }
};

/// Two images whose grey noise is independent, with the deviation of the whole.
Halves noisy(const ImageF& truth, double deviation, std::mt19937& random) {
    std::normal_distribution<float> noise(0.0f, static_cast<float>(deviation * std::sqrt(2.0)));
    Halves halves{truth, truth, truth};
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        halves.a.pixels[i] += glm::vec4(glm::vec3(noise(random)), 0.0f);
        halves.b.pixels[i] += glm::vec4(glm::vec3(noise(random)), 0.0f);
        halves.image.pixels[i] = 0.5f * (halves.a.pixels[i] + halves.b.pixels[i]);
    }
    return halves;
}

}  // namespace

TEST_CASE("Errors of four pixels are those that were worked out by hand") {
    const ImageF is = grey({1.5f, 1.0f, 4.0f, 0.25f}), should = grey({1.0f, 2.0f, 4.0f, 1.0f});
    const ImageErrors errors = imageErrors({is}, {should});
    CHECK(errors.bias == doctest::Approx(-1.25 / 8.0));
    CHECK(errors.relRmse == doctest::Approx(std::sqrt((0.25 + 1.0 + 0.5625) / 4.0) / 2.0));
    CHECK(errors.relRmseRaw == doctest::Approx(errors.relRmse));
    const double floor = 0.02 * 0.02;
    CHECK(errors.relMse ==
          doctest::Approx((0.25 / (1.0 + floor) + 1.0 / (4.0 + floor) + 0.5625 / (1.0 + floor)) /
                          4.0));
    CHECK(errors.p95 == doctest::Approx(0.75));
    CHECK(errors.noise == 0.0);
    CHECK(errors.relRmseSigma == 0.0);
}

TEST_CASE("Dark pixels are left out of the percentile, and alpha out of everything") {
    ImageF is = grey({1.0f, 1.1f, 0.5f}), should = grey({1.0f, 1.0f, 0.0099f});
    is.pixels[0].a = 0.0f;
    CHECK(imageErrors({is}, {should}).p95 == doctest::Approx(0.1));
    const std::vector<float> relative = relativeErrors(is, should);
    CHECK(relative[0] == 0.0f);
    CHECK(relative[1] == doctest::Approx(0.1));
    CHECK(relative[2] == doctest::Approx((0.5 - 0.0099) / 0.01));  // of 1 % of the brightest
}

TEST_CASE("Luminance weighs the colours as Rec. 709 does") {
    CHECK(luminance({1.0f, 0.0f, 0.0f, 1.0f}) == doctest::Approx(0.2126));
    CHECK(luminance({0.0f, 1.0f, 0.0f, 0.0f}) == doctest::Approx(0.7152));
    CHECK(luminance({0.0f, 0.0f, 1.0f, 1.0f}) == doctest::Approx(0.0722));
}

TEST_CASE(
    "A known error is found below noise five times as large, where the reference has halves") {
    std::mt19937 random(1);
    const ImageF is = ramp(1.05f);
    const Halves reference = noisy(ramp(), 0.25, random);
    const ImageErrors errors = imageErrors({is}, reference.sampled());
    CHECK(std::abs(errors.bias - 0.05) < 3.0 * errors.biasSigma);
    CHECK(errors.biasSigma == doctest::Approx(0.25 / kSide).epsilon(0.05));  // σ/√pixels
    CHECK(errors.noise == doctest::Approx(0.25).epsilon(0.05));
    CHECK(errors.relRmseRaw == doctest::Approx(std::hypot(0.05 * kRampRms, 0.25)).epsilon(0.05));
    CHECK(std::abs(errors.relRmse - 0.05 * kRampRms) < 3.0 * errors.relRmseSigma);
    // Of (d + n)² - α² with normal n and α of variance σ²: 4σ²(d² + σ²) a pixel.
    const double squaredSigma =
        std::pow(errors.relRmse + errors.relRmseSigma, 2) - std::pow(errors.relRmse, 2);
    const double d2 = std::pow(0.05 * kRampRms, 2), noise2 = 0.25 * 0.25;
    CHECK(squaredSigma ==
          doctest::Approx(std::sqrt(4.0 * noise2 * (d2 + noise2)) / kSide).epsilon(0.05));
}

TEST_CASE("Noise of both images is subtracted where both have halves") {
    std::mt19937 random(2);
    const Halves is = noisy(ramp(1.10f), 0.10, random), reference = noisy(ramp(), 0.05, random);
    const ImageErrors both = imageErrors(is.sampled(), reference.sampled());
    CHECK(both.noise == doctest::Approx(std::hypot(0.10, 0.05)).epsilon(0.05));
    CHECK(both.relRmse == doctest::Approx(0.10 * kRampRms).epsilon(0.05));
    const ImageErrors one = imageErrors({is.image}, reference.sampled());
    CHECK(one.relRmse == doctest::Approx(std::hypot(0.10 * kRampRms, 0.10)).epsilon(0.05));
}

TEST_CASE("The stated standard errors are those of repeated trials") {
    std::mt19937 random(3);
    const ImageF is = ramp(1.05f);
    constexpr int kTrials = 60;
    double bias = 0.0, rmse = 0.0;
    for (int i = 0; i < kTrials; ++i) {
        const Halves reference = noisy(ramp(), 0.1, random);
        const ImageErrors errors = imageErrors({is}, reference.sampled());
        bias += std::pow((errors.bias - 0.05) / errors.biasSigma, 2);
        rmse += std::pow((errors.relRmse - 0.05 * kRampRms) / errors.relRmseSigma, 2);
    }
    // A mean of 60 squared normal numbers deviates from 1 by 0.18; a ratio's denominator adds some.
    CHECK(std::abs(bias / kTrials - 1.0) < 0.6);
    CHECK(std::abs(rmse / kTrials - 1.0) < 0.6);
}

TEST_CASE("Images that differ by noise alone have no error left that noise does not explain") {
    std::mt19937 random(4);
    const Halves is = noisy(ramp(), 0.2, random), reference = noisy(ramp(), 0.2, random);
    const ImageErrors errors = imageErrors(is.sampled(), reference.sampled());
    CHECK(errors.relRmse <= 2.0 * errors.relRmseSigma);
    CHECK(std::abs(errors.bias) < 3.0 * errors.biasSigma);
}

TEST_CASE("What cannot be compared is refused with the reason") {
    const ImageF two = grey({1.0f, 2.0f}), three = grey({1.0f, 2.0f, 3.0f});
    CHECK_THROWS_WITH_AS(imageErrors({two}, {three}), doctest::Contains("2x1 and 3x1"), Error);
    CHECK_THROWS_WITH_AS(imageErrors({ImageF{}}, {ImageF{}}), doctest::Contains("no pixels"),
                         Error);
    CHECK_THROWS_WITH_AS(imageErrors({two}, {grey({0.0f, 0.0f})}), doctest::Contains("black"),
                         Error);
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        CHECK_THROWS_WITH_AS(imageErrors({grey({1.0f, bad})}, {two}),
                             doctest::Contains("column 1, row 0"), Error);
        CHECK_THROWS_WITH_AS(imageErrors({two}, {grey({bad, 1.0f})}),
                             doctest::Contains("the reference has"), Error);
    }
    CHECK_THROWS_AS(imageErrors({two}, {two, &three, &two}), Error);
}
