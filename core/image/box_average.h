// box_average.h: an image at a lower resolution, each pixel the mean of all that it covers.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "core/image/image.h"

namespace neph {

/// The size of an image with the shape of one of `sizePx` and about `mostPixels` pixels, no larger
/// than that one.
glm::ivec2 coarserSize(glm::ivec2 sizePx, int mostPixels);

/// Averages an image, given whole or in tiles, over the pixels of a coarser one of the same view.
/// Pixels on the border of two count for both by area.
class BoxAverage {
  public:
    /// `toPx`: at least 1 and no more than `wholePx`, each way.
    BoxAverage(glm::ivec2 wholePx, glm::ivec2 toPx);

    /// A tile; `atPx` is the place of its upper left pixel, from the upper left of the whole.
    void add(const ImageF& tile, glm::ivec2 atPx = glm::ivec2(0));

    /// The mean of all channels, once the whole image was added.
    ImageF mean() const;

  private:
    glm::ivec2 wholePx_, toPx_;
    std::vector<glm::dvec4> sums_;
};

}  // namespace neph
