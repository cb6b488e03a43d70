// denoise_test.cpp: the preview of images whose truth is known.
#include "core/image/denoise.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

using namespace neph;

namespace {

constexpr glm::ivec2 kSize(64, 48);
constexpr int kEdge = 30;  // first column of the bright side

/// A slope on the dark side of an edge, an even bright side.
glm::vec4 truthAt(int x, int y) {
    const float value = x < kEdge ? 0.2f + 0.002f * static_cast<float>(x + y) : 1.0f;
    return {value, 0.9f * value, 0.8f * value, 1.0f};
}

ImageF truth() {
    ImageF image{kSize, {}};
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) image.pixels.push_back(truthAt(x, y));
    }
    return image;
}

/// Halves of the truth, each with a deviation of its own at each pixel, a share of what is there.
std::array<ImageF, 2> noisyHalves(float share) {
    std::mt19937 random(11);
    std::normal_distribution<float> noise(0.0f, share);
    std::array<ImageF, 2> halves{truth(), truth()};
    for (ImageF& half : halves) {
        for (glm::vec4& pixel : half.pixels) {
            const float factor = 1.0f + noise(random);
            pixel = glm::vec4(factor * glm::vec3(pixel), 1.0f);
        }
    }
    return halves;
}

ImageF meanOf(const std::array<ImageF, 2>& halves) {
    ImageF mean = halves[0];
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        mean.pixels[i] = 0.5f * (mean.pixels[i] + halves[1].pixels[i]);
    }
    return mean;
}

double rmse(const ImageF& a, const ImageF& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::dvec3 d = glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]);
        sum += glm::dot(d, d);
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

/// Mean green of a column.
double columnOf(const ImageF& image, int x) {
    double sum = 0.0;
    for (int y = 0; y < image.size.y; ++y) {
        sum += static_cast<double>(image.pixels[static_cast<std::size_t>(y * image.size.x + x)].g);
    }
    return sum / image.size.y;
}

}  // namespace

TEST_CASE("A denoised preview is three times as close to the truth as the noisy image") {
    for (const float share : {0.1f, 0.4f}) {
        const std::array<ImageF, 2> halves = noisyHalves(share);
        CAPTURE(share);
        CHECK(rmse(denoised(halves[0], halves[1]), truth()) < rmse(meanOf(halves), truth()) / 3.0);
    }
}

TEST_CASE("Noise that is in a few bright pixels is averaged away, and most of its light stays") {
    // One path in six brings light: what one or two paths per pixel see of a thick cloud.
    constexpr float kShare = 1.0f / 6.0f;
    std::mt19937 random(7);
    std::bernoulli_distribution brings(static_cast<double>(kShare));
    std::array<ImageF, 2> halves{truth(), truth()};
    for (ImageF& half : halves) {
        for (glm::vec4& pixel : half.pixels) {
            const glm::vec3 colour = brings(random) ? glm::vec3(pixel) / kShare : glm::vec3(0.0f);
            pixel = glm::vec4(colour, 1.0f);
        }
    }
    const ImageF preview = denoised(halves[0], halves[1]);
    CHECK(rmse(preview, truth()) < rmse(meanOf(halves), truth()) / 5.0);
    double light = 0.0, traced = 0.0;
    for (int x = 0; x < kSize.x; ++x) {
        light += columnOf(preview, x);
        traced += columnOf(meanOf(halves), x);
    }
    CHECK(light > 0.95 * traced);
    CHECK(light < 1.05 * traced);
}

TEST_CASE("A denoised preview keeps an edge where it is") {
    const std::array<ImageF, 2> halves = noisyHalves(0.2f);
    const ImageF preview = denoised(halves[0], halves[1]);
    const ImageF wanted = truth();
    const double height = columnOf(wanted, kEdge) - columnOf(wanted, kEdge - 1);
    const double kept = columnOf(preview, kEdge) - columnOf(preview, kEdge - 1);
    CHECK(kept > 0.9 * height);
}

TEST_CASE("Where nothing is noisy a denoised preview is the image") {
    const ImageF still = truth();
    const ImageF preview = denoised(still, still);
    for (std::size_t i = 0; i < still.pixels.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            CHECK(std::abs(preview.pixels[i][c] - still.pixels[i][c]) < 1e-5f);
        }
    }
}

TEST_CASE("A single bright pixel does not spread in a denoised preview") {
    std::array<ImageF, 2> halves = noisyHalves(0.1f);
    const auto bright = static_cast<std::size_t>(20 * kSize.x + 15);
    halves[0].pixels[bright] = glm::vec4(1000.0f);
    const ImageF preview = denoised(halves[0], halves[1]);
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kEdge; ++x) {
            const auto i = static_cast<std::size_t>(y * kSize.x + x);
            if (i != bright) CHECK(preview.pixels[i].g < 2.0f * truthAt(x, y).g);
        }
    }
}

TEST_CASE("The number of threads does not change a denoised preview") {
    const std::array<ImageF, 2> halves = noisyHalves(0.3f);
    CHECK(rmse(denoised(halves[0], halves[1], 1), denoised(halves[0], halves[1], 3)) == 0.0);
}

TEST_CASE("Denoising ends as soon as it is told to") {
    const std::array<ImageF, 2> halves = noisyHalves(0.3f);
    int asked = 0;
    CHECK_THROWS_AS(denoised(halves[0], halves[1], 1, [&asked](double) { return ++asked < 3; }),
                    Cancelled);
    CHECK(asked == 3);
}
