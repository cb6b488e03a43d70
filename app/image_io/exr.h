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

/// How the colours of an image are stored.
struct ExrFormat {
    ExrFormat(ExrPixels pixelsIn = ExrPixels::half, bool isRadiance = false)
        : pixels(pixelsIn), radiance(isRadiance) {}
    ExrPixels pixels;
    /// They are radiance: stored in W m⁻² sr⁻¹, as core/sky/spectrum.h has it, with units in the
    /// header. Else as they are.
    bool radiance;
};

/// A channel in addition to the colours, one value per pixel, row 0 at the top. A dot in the name
/// separates the layer from the channel: "A.R", "optical_depth.cloud".
struct ImageLayer {
    std::string name;
    std::vector<float> values;
    int radiancePower = 0;  ///< 1: radiance in the image's unit, 2: its square; 0: neither
};

/// Colours and layers of equal size.
struct LayeredImage {
    ImageF colours;
    std::vector<ImageLayer> layers;
};

/// Appends the rows of `band`, which must have the same layers, below those of `image`.
void append(LayeredImage& image, const LayeredImage& band);

/// Writes channels R, G, B and A with ZIP compression, and metadata as string attributes of the
/// header. Half floats reach 65504; larger values are clipped, and their number is returned. Writes
/// to a temporary file, then renames it. Throws Error.
std::size_t writeExr(const std::filesystem::path& file, const ImageF& image,
                     const Metadata& metadata, ExrFormat format = {});

/// As above, but in bands: `next` returns the next rows from the top, until the image of `sizePx`
/// is complete. Every band has the layers of these names in this order; they are written as float.
/// Nothing is written if `next` throws.
std::size_t writeExr(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
                     ExrFormat format, const std::vector<std::string>& layers,
                     const std::function<LayeredImage()>& next);

/// The header's units of radiance: key and text.
inline constexpr const char* kRadianceUnitsKey = "radianceUnits";
inline constexpr const char* kRadianceUnits = "W m-2 sr-1";

/// What values of a file with such metadata are multiplied by to be those of an image again.
float imageUnitOfExr(const Metadata& metadata);

/// Missing channels read as 0, missing alpha as 1; radiance in those units becomes that of an image
/// again. String attributes are added to `metadata` unless it is null. Throws Error.
ImageF readExr(const std::filesystem::path& file, Metadata* metadata = nullptr);

/// The values of the named channels as the file has them, in that order; empty for a channel that
/// it lacks. Throws Error.
std::vector<std::vector<float>> readExrLayers(const std::filesystem::path& file,
                                              const std::vector<std::string>& names);

}  // namespace neph
