// box_average.cpp: shares of fine pixels in coarse ones, along each axis.
#include "core/image/box_average.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace neph {
namespace {

/// The coarse pixels that a fine one lies in, and how much of each it covers: two at most.
struct Shares {
    int first = 0;
    std::array<double, 2> of{};
};

Shares sharesOf(int fine, int from, int to) {
    // In fractions of from·to: whole numbers, so that nothing is rounded at borders.
    const long long lower = static_cast<long long>(fine) * to, upper = lower + to;
    Shares shares;
    shares.first = static_cast<int>(lower / from);
    const long long border = (shares.first + 1LL) * from;
    shares.of[0] = static_cast<double>(std::min(upper, border) - lower) / from;
    shares.of[1] = static_cast<double>(std::max(upper - border, 0LL)) / from;
    return shares;
}

}  // namespace

glm::ivec2 coarserSize(glm::ivec2 sizePx, int mostPixels) {
    const double pixels = static_cast<double>(sizePx.x) * sizePx.y;
    const double shrink = std::min(1.0, std::sqrt(mostPixels / pixels));
    return glm::max(glm::ivec2(glm::round(shrink * glm::dvec2(sizePx))), 1);
}

BoxAverage::BoxAverage(glm::ivec2 wholePx, glm::ivec2 toPx)
    : wholePx_(wholePx),
      toPx_(toPx),
      sums_(static_cast<std::size_t>(toPx.x) * static_cast<std::size_t>(toPx.y)) {
    assert(toPx.x >= 1 && toPx.y >= 1 && toPx.x <= wholePx.x && toPx.y <= wholePx.y);
}

void BoxAverage::add(const ImageF& tile, glm::ivec2 atPx) {
    const auto width = static_cast<std::size_t>(toPx_.x);
    std::size_t pixel = 0;
    for (int y = 0; y < tile.size.y; ++y) {
        const Shares rows = sharesOf(atPx.y + y, wholePx_.y, toPx_.y);
        for (int x = 0; x < tile.size.x; ++x) {
            const Shares columns = sharesOf(atPx.x + x, wholePx_.x, toPx_.x);
            const glm::dvec4 value(tile.pixels[pixel++]);
            for (std::size_t i = 0; i < 4; ++i) {
                const double share = rows.of[i / 2] * columns.of[i % 2];
                if (share <= 0.0) continue;
                sums_[(static_cast<std::size_t>(rows.first) + i / 2) * width +
                      static_cast<std::size_t>(columns.first) + i % 2] += share * value;
            }
        }
    }
}

ImageF BoxAverage::mean() const {
    ImageF image;
    image.size = toPx_;
    image.pixels.assign(sums_.begin(), sums_.end());
    return image;
}

}  // namespace neph
