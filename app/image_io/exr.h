// exr.h: linear images as OpenEXR files, with further data per pixel in layers. Alpha is
// premultiplied, as the format requires.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/image_io/metadata.h"
#include "core/image/image.h"

namespace neph {

enum class ExrPixels { half, full };

/// A channel in addition to the colours, one value per pixel, row 0 at the top. A dot in the name
/// separates the layer from the channel: "A.R", "optical_depth.cloud".
struct ImageLayer {
    std::string name;
    std::vector<float> values;
};

/// Colours and layers of equal size.
struct LayeredImage {
    ImageF colours;
    std::vector<ImageLayer> layers;
};

/// Appends the rows of `band`, which must have the same layers, below those of `image`.
void append(LayeredImage& image, const LayeredImage& band);

/// Writes channels R, G, B and A with ZIP compression, and metadata as string attributes of the
/// header. Half floats reach 65504; larger values are clipped. Writes to a temporary file, then
/// renames it. Throws Error.
void writeExr(const std::filesystem::path& file, const ImageF& image, const Metadata& metadata,
              ExrPixels pixels = ExrPixels::half);

/// As above, but in bands: `next` returns the next rows from the top, until the image of `sizePx`
/// is complete. Every band has the layers of these names in this order; they are written as float.
/// Nothing is written if `next` throws.
void writeExr(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
              ExrPixels pixels, const std::vector<std::string>& layers,
              const std::function<LayeredImage()>& next);

/// Missing channels read as 0, missing alpha as 1. String attributes are added to `metadata` unless
/// it is null. Throws Error.
ImageF readExr(const std::filesystem::path& file, Metadata* metadata = nullptr);

/// The values of the named channels, in that order; empty for a channel that the file lacks. Throws
/// Error.
std::vector<std::vector<float>> readExrLayers(const std::filesystem::path& file,
                                              const std::vector<std::string>& names);

}  // namespace neph
