// denoise.cpp: five rounds, each with twice the distance between the pixels that are averaged.
#include "core/image/denoise.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "core/base/parallel.h"
#include "core/image/image_error.h"

namespace neph {
namespace {

constexpr int kRounds = 5;
// A cubic B-spline at whole numbers, as far as 2. [Dammertz10]
constexpr std::array<float, 3> kSpline{3.0f / 8.0f, 1.0f / 4.0f, 1.0f / 16.0f};
// Median of the square of a normal deviate, over its mean.
constexpr float kMedianOfSquare = 0.455f;
constexpr float kTolerance = 1.0f;  // of differences, over what noise makes of them; tuned by eye

constexpr float kOutlier = 25.0f;  // times the variance; the square of a difference, tuned by eye
constexpr float kLeastTrust = 1e-6f;

/// A half under way: colours, and the luminance and its noise that the other is averaged by.
struct Layer {
    std::vector<glm::vec4> colour;
    std::vector<float> luminance;
    std::vector<float> variance;
    std::vector<float> trust;  ///< 1, but less where halves differ by more than noise around does
};

struct Grid {
    glm::ivec2 size;
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(std::clamp(y, 0, size.y - 1)) *
                   static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(std::clamp(x, 0, size.x - 1));
    }
};

/// Variance of a half, by the median of what the halves differ by around a pixel: a few bright
/// pixels are not to make all around them look noisy.
float varianceAround(const Grid& grid, const std::vector<float>& a, const std::vector<float>& b,
                     int x, int y) {
    std::array<float, 25> squares{};
    for (int i = 0; i < 25; ++i) {
        const std::size_t at = grid.at(x + i % 5 - 2, y + i / 5 - 2);
        const float difference = a[at] - b[at];
        squares[static_cast<std::size_t>(i)] = 0.5f * difference * difference;
    }
    std::nth_element(squares.begin(), squares.begin() + 12, squares.end());
    return squares[12] / kMedianOfSquare;
}

/// How far two pixels differ beyond noise, over 3 x 3 pixels around both; about 0 where they show
/// the same.
float differenceBeyondNoise(const Grid& grid, const Layer& guide, glm::ivec2 p, glm::ivec2 q) {
    float sum = 0.0f;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const std::size_t a = grid.at(p.x + dx, p.y + dy);
            const std::size_t b = grid.at(q.x + dx, q.y + dy);
            const float difference = guide.luminance[a] - guide.luminance[b];
            // Not the noise of a brighter neighbour, which would let it in.
            const float noise = guide.variance[a] + std::min(guide.variance[a], guide.variance[b]);
            const float scale = kTolerance * noise + 1e-20f;
            sum += std::min((difference * difference - noise) / scale, 100.0f);
        }
    }
    return sum / 9.0f;
}

/// One pixel of a half, averaged.
void averageAt(const Grid& grid, const Layer& half, const Layer& guide, glm::ivec2 p, int step,
               Layer& out) {
    glm::vec4 colour(0.0f);
    float weights = 0.0f, variance = 0.0f;
    const std::size_t here = grid.at(p.x, p.y);
    for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
            const glm::ivec2 q = p + step * glm::ivec2(dx, dy);
            if (q.x < 0 || q.y < 0 || q.x >= grid.size.x || q.y >= grid.size.y) continue;
            const float beyond =
                dx == 0 && dy == 0 ? 0.0f : differenceBeyondNoise(grid, guide, p, q);
            const std::size_t there = grid.at(q.x, q.y);
            const float weight = kSpline[static_cast<std::size_t>(std::abs(dx))] *
                                 kSpline[static_cast<std::size_t>(std::abs(dy))] *
                                 half.trust[there] * std::exp(-std::max(beyond, 0.0f));
            colour += weight * half.colour[there];
            variance += weight * weight * half.variance[there];
            weights += weight;
        }
    }
    out.colour[here] = colour / weights;
    out.variance[here] = variance / (weights * weights);
    out.luminance[here] = luminance(out.colour[here]);
}

Layer layerOf(const ImageF& half) {
    const std::size_t pixels = half.pixels.size();
    Layer layer{half.pixels, {}, std::vector<float>(pixels), std::vector<float>(pixels, 1.0f)};
    for (const glm::vec4& pixel : half.pixels) layer.luminance.push_back(luminance(pixel));
    return layer;
}

}  // namespace

ImageF denoised(const ImageF& halfA, const ImageF& halfB, std::size_t threads) {
    assert(halfA.size == halfB.size);
    const Grid grid{halfA.size};
    std::array<Layer, 2> halves{layerOf(halfA), layerOf(halfB)};
    const auto rows = static_cast<std::size_t>(grid.size.y);
    const auto everywhere = [&](const auto& work) {
        shareOut(rows, threads, [&](std::size_t row, std::size_t, const Progress&) {
            for (int x = 0; x < grid.size.x; ++x) work(x, static_cast<int>(row));
        });
    };
    everywhere([&](int x, int y) {
        const std::size_t at = grid.at(x, y);
        const float variance = varianceAround(grid, halves[0].luminance, halves[1].luminance, x, y);
        const float difference = halves[0].luminance[at] - halves[1].luminance[at];
        const float square = std::max(difference * difference, 1e-30f);
        for (Layer& half : halves) {
            half.variance[at] = variance;
            half.trust[at] = std::clamp(kOutlier * 2.0f * variance / square, kLeastTrust, 1.0f);
        }
    });
    for (int round = 0; round < kRounds; ++round) {
        std::array<Layer, 2> next = halves;
        everywhere([&](int x, int y) {
            averageAt(grid, halves[0], halves[1], {x, y}, 1 << round, next[0]);
            averageAt(grid, halves[1], halves[0], {x, y}, 1 << round, next[1]);
        });
        halves = std::move(next);
        for (Layer& half : halves) std::ranges::fill(half.trust, 1.0f);
    }
    ImageF image{grid.size, {}};
    for (std::size_t i = 0; i < halfA.pixels.size(); ++i) {
        const glm::vec3 mean(0.5f * (halves[0].colour[i] + halves[1].colour[i]));
        image.pixels.emplace_back(mean, 0.5f * (halfA.pixels[i].a + halfB.pixels[i].a));
    }
    return image;
}

}  // namespace neph
