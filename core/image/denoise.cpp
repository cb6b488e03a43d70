// denoise.cpp: five rounds, each with twice the distance between the pixels that are averaged.
#include "core/image/denoise.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"
#include "core/image/image_error.h"

namespace neph {
namespace {

constexpr int kRounds = 5;
// A cubic B-spline at whole numbers, as far as 2. [Dammertz10]
constexpr std::array<float, 3> kSpline{3.0f / 8.0f, 1.0f / 4.0f, 1.0f / 16.0f};
// Mean of the square of a normal deviate but for the largest twenty-fifth.
constexpr float kMeanButLargest = 0.793f;
constexpr float kCaution = 1.25f;   // times what noise seems to be; tuned by eye
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

/// Variance of a half, by what the halves differ by around a pixel, but for the largest: a single
/// bright pixel is not to make all around it look noisy. With few paths per pixel most of the noise
/// is in a few pixels, so that the median, say, would hardly see it.
float varianceAround(const Grid& grid, const std::vector<float>& a, const std::vector<float>& b,
                     int x, int y) {
    std::array<float, 25> squares{};
    for (int i = 0; i < 25; ++i) {
        const std::size_t at = grid.at(x + i % 5 - 2, y + i / 5 - 2);
        const float difference = a[at] - b[at];
        squares[static_cast<std::size_t>(i)] = 0.5f * difference * difference;
    }
    std::iter_swap(std::ranges::max_element(squares), squares.end() - 1);
    const float sum = std::accumulate(squares.begin(), squares.end() - 1, 0.0f);
    return kCaution * sum / (24.0f * kMeanButLargest);
}

/// How far two pixels differ beyond noise; negative where by less than that.
float beyondNoise(const Layer& guide, std::size_t a, std::size_t b) {
    const float difference = guide.luminance[a] - guide.luminance[b];
    // Not the noise of a brighter neighbour, which would let it in.
    const float noise = guide.variance[a] + std::min(guide.variance[a], guide.variance[b]);
    const float scale = kTolerance * noise + 1e-20f;
    return std::min((difference * difference - noise) / scale, 100.0f);
}

/// Rows of a half that one thread averages, a tap of the spline at a time: pixels that lie side by
/// side share most of what their surroundings differ by.
class Rows {
  public:
    Rows(const Grid& grid, int first)
        : grid_(grid),
          first_(first),
          count_(std::min(kRows, grid.size.y - first)),
          columns_(grid.size.x + 2),
          beyond_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(count_ + 2)),
          colour_(static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(count_)),
          weight_(colour_.size()),
          variance_(colour_.size()) {}

    static int piecesOf(const Grid& grid) { return (grid.size.y + kRows - 1) / kRows; }
    static int firstOf(std::size_t piece) { return kRows * static_cast<int>(piece); }

    void average(const Layer& half, const Layer& guide, int step, Layer& out) {
        std::ranges::fill(colour_, glm::vec4(0.0f));
        std::ranges::fill(weight_, 0.0f);
        std::ranges::fill(variance_, 0.0f);
        for (int dy = -2; dy <= 2; ++dy) {
            for (int dx = -2; dx <= 2; ++dx) {
                const glm::ivec2 away = step * glm::ivec2(dx, dy);
                compare(guide, away);
                add(half, away,
                    kSpline[static_cast<std::size_t>(std::abs(dx))] *
                        kSpline[static_cast<std::size_t>(std::abs(dy))]);
            }
        }
        for (std::size_t i = 0; i < colour_.size(); ++i) {
            const std::size_t at = grid_.at(0, first_) + i;
            out.colour[at] = colour_[i] / weight_[i];
            out.variance[at] = variance_[i] / (weight_[i] * weight_[i]);
            out.luminance[at] = luminance(out.colour[at]);
        }
    }

  private:
    static constexpr int kRows = 16;

    std::size_t indexOf(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    /// What the pixels, and those around, differ by from others so far `away`, three side by side
    /// together.
    void compare(const Layer& guide, glm::ivec2 away) {
        if (away == glm::ivec2(0)) {
            std::ranges::fill(beyond_, 0.0f);
            return;
        }
        for (int row = 0; row < count_ + 2; ++row) {
            const int y = first_ + row - 1;
            float before = 0.0f, here = 0.0f;
            for (int column = 0; column < columns_; ++column) {
                const int x = column - 1;
                const float next =
                    beyondNoise(guide, grid_.at(x, y), grid_.at(x + away.x, y + away.y));
                beyond_[indexOf(column, row)] = before + here + next;
                before = std::exchange(here, next);
            }
        }
    }

    void add(const Layer& half, glm::ivec2 away, float spline) {
        const int lower = std::max(0, -away.x);
        const int upper = std::min(grid_.size.x, grid_.size.x - away.x);
        for (int row = 0; row < count_; ++row) {
            const int y = first_ + row + away.y;
            if (y < 0 || y >= grid_.size.y) continue;
            for (int x = lower; x < upper; ++x) {
                const float sum = beyond_[indexOf(x + 2, row)] + beyond_[indexOf(x + 2, row + 1)] +
                                  beyond_[indexOf(x + 2, row + 2)];
                const std::size_t there = grid_.at(x + away.x, y);
                const float weight =
                    spline * half.trust[there] * std::exp(-std::max(sum / 9.0f, 0.0f));
                const std::size_t at = static_cast<std::size_t>(row * grid_.size.x + x);
                colour_[at] += weight * half.colour[there];
                variance_[at] += weight * weight * half.variance[there];
                weight_[at] += weight;
            }
        }
    }

    const Grid& grid_;
    int first_, count_, columns_;  // columns: one more on either side
    std::vector<float> beyond_;    // row by row, one more above and below
    std::vector<glm::vec4> colour_;
    std::vector<float> weight_, variance_;
};

Layer layerOf(const ImageF& half) {
    const std::size_t pixels = half.pixels.size();
    Layer layer{half.pixels, {}, std::vector<float>(pixels), std::vector<float>(pixels, 1.0f)};
    for (const glm::vec4& pixel : half.pixels) layer.luminance.push_back(luminance(pixel));
    return layer;
}

/// Noise of each pixel of both halves, and how far it is to be trusted.
void estimateNoise(const Grid& grid, std::array<Layer, 2>& halves, std::size_t threads,
                   const Progress& progress) {
    const auto estimate = [&](std::size_t row, std::size_t, const Progress&) {
        for (int x = 0; x < grid.size.x; ++x) {
            const int y = static_cast<int>(row);
            const std::size_t at = grid.at(x, y);
            const float variance =
                varianceAround(grid, halves[0].luminance, halves[1].luminance, x, y);
            const float difference = halves[0].luminance[at] - halves[1].luminance[at];
            const float square = std::max(difference * difference, 1e-30f);
            for (Layer& half : halves) {
                half.variance[at] = variance;
                half.trust[at] = std::clamp(kOutlier * 2.0f * variance / square, kLeastTrust, 1.0f);
            }
        }
    };
    shareOut(static_cast<std::size_t>(grid.size.y), threads, estimate, progress);
}

}  // namespace

ImageF denoised(const ImageF& halfA, const ImageF& halfB, std::size_t threads,
                const Progress& progress) {
    assert(halfA.size == halfB.size);
    const Grid grid{halfA.size};
    std::array<Layer, 2> halves{layerOf(halfA), layerOf(halfB)};
    estimateNoise(grid, halves, threads, progress);
    const auto pieces = static_cast<std::size_t>(Rows::piecesOf(grid));
    for (int round = 0; round < kRounds; ++round) {
        std::array<Layer, 2> next = halves;
        const auto average = [&](std::size_t piece, std::size_t, const Progress&) {
            Rows rows(grid, Rows::firstOf(piece));
            rows.average(halves[0], halves[1], 1 << round, next[0]);
            rows.average(halves[1], halves[0], 1 << round, next[1]);
        };
        shareOut(pieces, threads, average, progress);
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
