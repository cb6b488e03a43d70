// bands.h: an image drawn from the top in bands of rows, each in tiles that the GPU takes, so that
// its size is bounded by neither GPU nor memory.
//
// The tiles' rays are those of the whole image, and so are the slices of the slicing engine: the
// seams cannot be seen. Two sides may share an image; a thin line is between them.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/image_io/exr.h"
#include "app/render/renderer.h"
#include "core/base/progress.h"
#include "core/image/box_average.h"
#include "core/image/image.h"

namespace neph {

/// What a part of the image shows.
struct DrawnSide {
    render::Renderer* renderer = nullptr;  ///< holds the volume
    render::FrameInputs inputs;            ///< of the whole image
    int samples = 1;                       ///< of each tile
    double targetError = 0.0;  ///< relative standard error at which a tile is done; 0: none
    bool denoise = false;      ///< colours are a preview; of one tile, one ray per pixel
    int fromPx = 0, toPx = 0;  ///< its columns; the second is outside
};

/// How a side was drawn: "march, 512 steps, 8 samples".
std::string workText(const DrawnSide& side, const render::FrameStats& stats);

class Bands {
  public:
    /// The sides are the columns of one image, from the left. `progress` gets the share of it
    /// that is there.
    Bands(std::vector<DrawnSide> sides, Progress progress);

    /// The next rows; call until all `sizePx().y` are there. Throws Cancelled.
    Image8 nextDisplay();
    ImageF nextLinear();
    /// With what the engine knows besides, where it draws the whole image, one ray per pixel.
    LayeredImage nextLayered();
    /// Names of the layers that there are then.
    std::vector<std::string> layerNames() const;

    /// From now on, keeps the mean of what is drawn at a lower resolution, in linear light.
    void average(glm::ivec2 toPx) { average_.emplace(sizePx_, toPx); }
    /// That mean, once all rows are there.
    ImageF averaged() const { return average_.value().mean(); }

    glm::ivec2 sizePx() const { return sizePx_; }
    /// Of what was drawn so far, all sides and tiles together.
    const render::FrameStats& stats() const { return stats_; }
    const std::vector<DrawnSide>& sides() const { return sides_; }
    int tiles() const { return tiles_; }

  private:
    template <typename Image>
    Image next(std::vector<ImageLayer>* layers = nullptr);
    bool layered() const;
    void draw(const DrawnSide& side, glm::ivec2 lowerPx, glm::ivec2 tilePx);
    void preview(const DrawnSide& side);

    std::vector<DrawnSide> sides_;
    Progress progress_;
    glm::ivec2 sizePx_{0}, tilePx_{1};
    int row_ = 0;  // the first that is not there yet, from the top
    int tiles_ = 0;
    std::size_t donePx_ = 0;
    render::FrameStats stats_;
    std::optional<BoxAverage> average_;
    std::optional<ImageF> preview_;  // of the tile, where it is denoised
};

}  // namespace neph
