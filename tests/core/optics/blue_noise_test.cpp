// blue_noise_test.cpp: the tile of ranks: complete, even, and without low frequencies.
#include "core/optics/blue_noise.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

using namespace neph;

namespace {

constexpr int kSide = kBlueNoiseSize;

/// Of one frequency, in periods a tile: the squared magnitude of the Fourier sum, per place.
double power(const std::vector<float>& values, int fx, int fy) {
    std::complex<double> sum = 0.0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double turns = static_cast<double>(fx * x + fy * y) / kSide;
            sum += static_cast<double>(values[static_cast<std::size_t>(y * kSide + x)]) *
                   std::polar(1.0, -2.0 * std::numbers::pi * turns);
        }
    }
    return std::norm(sum) / (kSide * kSide);
}

/// Mean power of the frequencies from `lo` to below `hi` periods a tile, constant part aside. White
/// noise has its variance at every frequency.
double meanPower(const std::vector<float>& values, double lo, double hi) {
    double sum = 0.0;
    int count = 0;
    for (int fy = -kSide / 2; fy < kSide / 2; ++fy) {
        for (int fx = 0; fx < kSide / 2; ++fx) {  // the other half is its mirror image
            const double radius = std::hypot(fx, fy);
            if (radius == 0.0 || radius < lo || radius >= hi) continue;
            sum += power(values, fx, fy);
            ++count;
        }
    }
    return sum / count;
}

}  // namespace

TEST_CASE("Blue noise holds each of its 4096 values once") {
    std::vector<float> values = blueNoise();
    REQUIRE(values.size() == 4096);
    std::sort(values.begin(), values.end());
    for (std::size_t rank = 0; rank < values.size(); ++rank) {
        REQUIRE(values[rank] == (static_cast<float>(rank) + 0.5f) / 4096.0f);
    }
}

TEST_CASE("Below a quarter of the Nyquist frequency blue noise has hardly any power") {
    // The variance of 4096 evenly spaced values from 0 to 1 is 1/12, less their spacing squared.
    const double white = (1.0 - 1.0 / (4096.0 * 4096.0)) / 12.0;
    CHECK(meanPower(blueNoise(), 0.0, kSide / 8.0) < 0.002 * white);
    CHECK(meanPower(blueNoise(), kSide / 8.0, kSide / 4.0) < 0.05 * white);
    CHECK(meanPower(blueNoise(), 26.0, 32.0) > white);
}

TEST_CASE("Blue noise below any threshold is spread evenly over the tile, edges included") {
    for (const int points : {64, 410, 1024, 2048}) {
        std::vector<float> below;
        for (const float value : blueNoise()) {
            below.push_back(value * 4096.0f < static_cast<float>(points) ? 1.0f : 0.0f);
        }
        CAPTURE(points);
        const double share = points / 4096.0;
        CHECK(meanPower(below, 0.0, 4.0) < 0.15 * share * (1.0 - share));
    }
}
