// bands.cpp: tile by tile, sample by sample.
#include "app/cli/render/bands.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/cli/render/reference_channels.h"
#include "app/render/frame/tiles.h"
#include "app/workbench/profile_text.h"
#include "core/base/parallel.h"
#include "core/image/denoise.h"

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

/// The same of a channel of `widthPx`.
void paste(const std::vector<float>& tile, glm::ivec2 tilePx, int x, std::vector<float>& band,
           int widthPx) {
    for (int y = 0; y < tilePx.y; ++y) {
        std::copy_n(tile.begin() + static_cast<std::ptrdiff_t>(y) * tilePx.x, tilePx.x,
                    band.begin() + static_cast<std::ptrdiff_t>(y) * widthPx + x);
    }
}

/// Puts what the engine knows of a tile into a band.
void pasteLayers(const render::FrameLayers& known, int x, int widthPx,
                 std::vector<ImageLayer>& band) {
    std::vector<ImageLayer> tile = channelsOf(known);
    for (std::size_t i = 0; i < tile.size(); ++i) {
        band[i].radiancePower = tile[i].radiancePower;
        std::vector<float>& values = band[i].values;
        values.resize(static_cast<std::size_t>(widthPx) * static_cast<std::size_t>(known.size.y));
        paste(tile[i].values, known.size, x, values, widthPx);
    }
}

}  // namespace

std::string workText(const DrawnSide& side, const render::FrameStats& stats) {
    const EngineTraits& engine = traitsOf(side.inputs.look.engine);
    const std::string rays =
        side.inputs.supersample == 1
            ? std::string()
            : fmt::format(", {0} x {0} rays per pixel", side.inputs.supersample);
    if (engine.refinement == Refinement::converges) {
        return fmt::format("{}, {} per ray, error {:.2f} %{}{}", engine.id,
                           countText(stats.reference.samples, engine.unit),
                           100.0 * stats.reference.relativeError,
                           side.denoise ? " before noise was removed: denoised preview" : "", rays);
    }
    std::string work = fmt::format("{}, {}", engine.id, countText(stats.planes, engine.unit));
    if (engine.refinement == Refinement::averages) work += ", " + countText(side.samples, "sample");
    return work + rays;
}

Bands::Bands(std::vector<DrawnSide> sides, Progress progress)
    : sides_(std::move(sides)),
      progress_(std::move(progress)),
      sizePx_(sides_.front().inputs.sizePx),
      tilePx_(render::tileSize(sizePx_, sides_.front().inputs.supersample,
                               sides_.front().renderer->largestSidePx(), render::kMostTileRays)) {}

/// All samples of one tile, or as many as the error needs, which falls with the square root of
/// their number.
void Bands::draw(const DrawnSide& side, glm::ivec2 lowerPx, glm::ivec2 tilePx) {
    render::FrameInputs inputs = side.inputs;
    inputs.part = render::ImagePart{sizePx_, lowerPx};
    inputs.sizePx = tilePx;
    const double tileShare =
        static_cast<double>(count(tilePx)) / static_cast<double>(count(sizePx_));
    const double before = static_cast<double>(donePx_) / static_cast<double>(count(sizePx_));
    const ReferenceProgress others = stats_.reference;
    double needed = side.samples;
    render::Accumulation image;
    while (image.samples() < side.samples) {
        const auto within = [&](double share) {
            return goOn(progress_,
                        before + tileShare * std::min((image.samples() + share) / needed, 1.0));
        };
        const render::FrameStats stats = side.renderer->render(inputs, image, within);
        if (tiles_ == 0 && image.samples() == 1) {
            stats_ = stats;
        } else {
            addSample(stats_, stats);
        }
        const ReferenceProgress& traced = stats.reference;
        stats_.reference = together(others, traced);
        if (traced.samples < 2 || side.targetError <= 0.0) continue;
        if (traced.relativeError <= side.targetError) break;
        needed = std::min(1.0 * side.samples, traced.samples * workTo(side.targetError, traced));
    }
    if (average_) {
        average_->add(side.renderer->readLinear(), {lowerPx.x, sizePx_.y - lowerPx.y - tilePx.y});
    }
    if (side.denoise) preview(side);
    donePx_ += count(tilePx);
    ++tiles_;
}

/// Of what was drawn last.
void Bands::preview(const DrawnSide& side) {
    const std::array<ImageF, 2> halves = side.renderer->readHalves();
    preview_ = denoised(halves[0], halves[1], workerCount(kMostDenoisers));
    side.renderer->showPreview(*preview_, side.inputs);
}

template <typename Image>
Image Bands::next(std::vector<ImageLayer>* layers) {
    const int rows = std::min(tilePx_.y, sizePx_.y - row_);
    Image band = emptyBand({sizePx_.x, rows}, static_cast<const Image*>(nullptr));
    for (const DrawnSide& side : sides_) {
        for (int x = side.fromPx; x < side.toPx; x += tilePx_.x) {
            draw(side, {x, sizePx_.y - row_ - rows}, {std::min(tilePx_.x, side.toPx - x), rows});
            Image tile = [&] {
                if constexpr (std::is_same_v<Image, Image8>) {
                    return side.renderer->readDisplay();
                } else {
                    return side.denoise ? preview_.value() : side.renderer->readLinear();
                }
            }();
            paste(tile, x, band);
            if (layers != nullptr) {
                pasteLayers(side.renderer->readLayers().value(), x, sizePx_.x, *layers);
            }
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

bool Bands::layered() const {
    const render::FrameInputs& inputs = sides_.front().inputs;
    return sides_.size() == 1 && traitsOf(inputs.look.engine).layers && inputs.supersample == 1;
}

std::vector<std::string> Bands::layerNames() const {
    return layered() ? referenceChannels() : std::vector<std::string>{};
}

LayeredImage Bands::nextLayered() {
    LayeredImage band;
    for (const std::string& name : layerNames()) band.layers.push_back({name, {}, 0});
    band.colours = next<ImageF>(layered() ? &band.layers : nullptr);
    return band;
}

}  // namespace neph
