// bands.cpp: tile by tile, sample by sample.
#include "app/cli/bands.h"

#include <algorithm>
#include <utility>

#include "app/cli/profile_text.h"
#include "app/render/tiles.h"

namespace neph {
namespace {

constexpr double kLinePerHeight = 1.0 / 540.0;  // of the line between the sides; tuned by eye

std::size_t count(glm::ivec2 sizePx) {
    return static_cast<std::size_t>(sizePx.x) * static_cast<std::size_t>(sizePx.y);
}

Image8 emptyBand(glm::ivec2 sizePx, const Image8*) {
    return {sizePx, std::vector<std::uint8_t>(4 * count(sizePx), 255)};
}
ImageF emptyBand(glm::ivec2 sizePx, const ImageF*) {
    return {sizePx, std::vector<glm::vec4>(count(sizePx), glm::vec4(1.0f))};
}
auto pixelAt(Image8& image, int x, int y) {
    return image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.size.x + x);
}
auto pixelAt(ImageF& image, int x, int y) {
    return image.pixels.begin() + (static_cast<std::ptrdiff_t>(y) * image.size.x + x);
}

/// Puts a tile into a band whose first row is the tile's.
template <typename Image>
void paste(Image& tile, int x, Image& band) {
    for (int y = 0; y < tile.size.y; ++y) {
        std::copy(pixelAt(tile, 0, y), pixelAt(tile, tile.size.x, y), pixelAt(band, x, y));
    }
}

}  // namespace

Bands::Bands(std::vector<DrawnSide> sides, Progress progress)
    : sides_(std::move(sides)),
      progress_(std::move(progress)),
      sizePx_(sides_.front().inputs.sizePx),
      tilePx_(render::tileSize(sizePx_, sides_.front().inputs.supersample,
                               sides_.front().renderer->largestSidePx(), render::kMostTileRays)) {}

/// All samples of one tile.
void Bands::draw(const DrawnSide& side, glm::ivec2 lowerPx, glm::ivec2 tilePx) {
    render::FrameInputs inputs = side.inputs;
    inputs.part = render::PicturePart{sizePx_, lowerPx};
    inputs.sizePx = tilePx;
    const double tileShare =
        static_cast<double>(count(tilePx)) / static_cast<double>(count(sizePx_));
    const double before = static_cast<double>(donePx_) / static_cast<double>(count(sizePx_));
    for (; inputs.sample < side.samples; ++inputs.sample) {
        const auto within = [&](double share) {
            return goOn(progress_, before + tileShare * (inputs.sample + share) / side.samples);
        };
        const render::FrameStats stats = side.renderer->render(inputs, within);
        if (tiles_ == 0 && inputs.sample == 0) {
            stats_ = stats;
        } else {
            addSample(stats_, stats);
        }
    }
    donePx_ += count(tilePx);
    ++tiles_;
}

template <typename Image>
Image Bands::next() {
    const int rows = std::min(tilePx_.y, sizePx_.y - row_);
    Image band = emptyBand({sizePx_.x, rows}, static_cast<const Image*>(nullptr));
    for (const DrawnSide& side : sides_) {
        for (int x = side.fromPx; x < side.toPx; x += tilePx_.x) {
            draw(side, {x, sizePx_.y - row_ - rows}, {std::min(tilePx_.x, side.toPx - x), rows});
            Image tile = [&] {
                if constexpr (std::is_same_v<Image, Image8>) {
                    return side.renderer->readDisplay();
                } else {
                    return side.renderer->readLinear();
                }
            }();
            paste(tile, x, band);
        }
    }
    row_ += rows;
    if (sides_.size() == 1) return band;
    // White, in the middle between the sides.
    const int line = std::max(1, static_cast<int>(kLinePerHeight * sizePx_.y));
    const int from = std::clamp(sides_.front().toPx - line / 2, 0, sizePx_.x - line);
    Image white = emptyBand({line, rows}, static_cast<const Image*>(nullptr));
    paste(white, from, band);
    return band;
}

Image8 Bands::nextDisplay() {
    return next<Image8>();
}

ImageF Bands::nextLinear() {
    return next<ImageF>();
}

}  // namespace neph
