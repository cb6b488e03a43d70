// reference_channels.h: what the reference knows of each pixel, as channels of an EXR file.
//
// A.R to B.B: means of the even and of the odd paths. variance.R to variance.B: of the mean.
// transmittance, optical_depth.cloud and so on: of the ray through the pixel's middle.
// depth.first_scatter: mean metres from the eye to the first scattering, infinite where none is.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/image_io/exr.h"
#include "app/render/frame/frame_layers.h"

namespace neph {

/// What the metadata of an image say whose colours are a denoised preview: key and text.
inline constexpr const char* kDenoisedKey = "nephoscope.denoised";
inline constexpr const char* kDenoisedText = "denoised preview: for looking at, not for figures";

/// The names of all channels, in the order in which they are written.
const std::vector<std::string>& referenceChannels();

/// Those of the halves alone, which are the first.
const std::vector<std::string>& halfChannels();

struct Halves {
    ImageF a, b;
};

/// The halves of an image of `size` from the values of their channels, in that order; none where
/// one of them is missing.
std::optional<Halves> halvesFrom(const std::vector<std::vector<float>>& channels, glm::ivec2 size);

/// The channels of an image, or of a part of it. A species that there is not has no optical depth.
std::vector<ImageLayer> channelsOf(const render::FrameLayers& layers);

}  // namespace neph
