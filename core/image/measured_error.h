// measured_error.h: the error of one image, measured against the reference of the same view at a
// lower resolution, as figures, in words, and where it is. docs/compare.md
//
// A reference of few paths has pixels that one path in a thousand made many times too bright, and
// one of them would drown all else. What a pixel of a half has beyond twice the sum of the image
// around it, the other half around it and the mean of both is spread over the image, in proportion
// to its brightness: no light is lost, and with more paths ever less of it is spread. Where that
// would be in more than 1 % of the pixels, it is four times the sum, or eight and so on: then the
// reference is noisy, and the standard error has to say so.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/image/image_error.h"

namespace neph {

/// How far an image is from the reference, as far as that is known.
struct MeasuredError {
    ImageErrors errors;    ///< of the image averaged to `sizePx`, noise subtracted
    glm::ivec2 sizePx{0};  ///< of the reference
    int paths = 0;         ///< of it, per pixel
    double spread = 0.0;   ///< share of the reference's light that was spread over the image
};

/// `image`: linear radiance averaged to the size of `halves`, the means of the even and the odd
/// ones of `paths` paths per pixel, equally many. Throws Error as imageErrors.
MeasuredError measureError(const ImageF& image, const std::array<ImageF, 2>& halves, int paths);

/// Whether more paths would say little more: the standard error is a tenth of the error, or 0.3 %.
bool isKnownWell(const MeasuredError& measured);

/// "3.1 % ± 0.4 (bias -0.2 %)": relRMSE, its standard error, and the bias.
std::string errorText(const MeasuredError& measured);

/// What the figures are: of what, and against how much of a reference.
std::string meaningOf(const MeasuredError& measured);

/// (I-R)/R of the luminance as relativeErrors, of means over 3 x 3 pixels around each; 0 where the
/// difference is less than two standard errors, as the halves of the 5 x 5 pixels around have it.
std::vector<float> errorsBeyondNoise(const ImageF& image, const std::array<ImageF, 2>& halves);

}  // namespace neph
