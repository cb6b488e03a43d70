// error_picture.h: errors of a picture's pixels as colours, with a legend that says what they mean.
//
// sRGB, 8 bits. Magnitudes go along magma, from black, no error, to pale yellow; signed errors
// along cool-warm, from blue, too dark, over grey to red, too bright. docs/references.md
#pragma once
#include <span>
#include <string>

#include "core/image/image.h"

namespace neph {

struct ErrorScale {
    double most = 1.0;       ///< error at the end of the bar; larger ones have its colour
    bool bothSigns = false;  ///< the bar goes from -most; else from 0, and signs are left out
    bool percent = true;     ///< the numbers at the bar, of an error of which 1 is 100 %
    std::string title{};     ///< before the bar: "|A-B|/B", of the characters that there are
};

/// sRGB in [0, 1] of an error.
glm::vec3 errorColour(double error, const ErrorScale& scale);

/// 1, 2 or 5 times a power of ten which the magnitudes of 99 % of `errors` do not exceed; at least
/// 0.1 %.
double roundEnd(std::span<const float> errors);

/// The errors of a picture of `size`, row 0 on top, and a bar with numbers below it.
Image8 errorPicture(glm::ivec2 size, std::span<const float> errors, const ErrorScale& scale);

}  // namespace neph
