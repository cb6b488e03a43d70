// exr.h: linear pictures as OpenEXR files, with what else is known of each pixel; premultiplied
// alpha, as the format wants it.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/image_io/metadata.h"
#include "core/image/image.h"

namespace neph {

enum class ExrPixels { half, full };

/// A channel beside the colours, one value a pixel, row 0 on top. A dot in the name separates a
/// layer from its channel: "A.R", "optical_depth.cloud".
struct ImageLayer {
    std::string name;
    std::vector<float> values;
};

struct LayeredImage {
    ImageF colours;
    std::vector<ImageLayer> layers;
};

/// Puts the rows of `band`, which has the same layers, below those of `image`.
void append(LayeredImage& image, const LayeredImage& band);

/// Channels R, G, B, A, ZIP compression, metadata as string attributes of the header. Half holds
/// values to 65504; larger ones are clipped to it. Written aside, then renamed. Throws Error.
void writeExr(const std::filesystem::path& file, const ImageF& image, const Metadata& metadata,
              ExrPixels pixels = ExrPixels::half);

/// The same of `sizePx`, from the bands of rows that `next` gives, from the top, until they are all
/// there; all have the layers of these names in this order, which are written as float. What `next`
/// throws leaves no file.
void writeExr(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
              ExrPixels pixels, const std::vector<std::string>& layers,
              const std::function<LayeredImage()>& next);

/// Missing channels read as 0, missing alpha as 1. String attributes are added to `metadata` where
/// given. Throws Error.
ImageF readExr(const std::filesystem::path& file, Metadata* metadata = nullptr);

/// The values of channels by their names, in that order; empty where the file has none of that
/// name. Throws Error.
std::vector<std::vector<float>> readExrLayers(const std::filesystem::path& file,
                                              const std::vector<std::string>& names);

}  // namespace neph
