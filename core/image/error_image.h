// error_image.h: shows the error of each pixel as a colour, with a legend.
//
// 8-bit sRGB. Magnitudes use the colour map magma, from black (no error) to pale yellow; signed
// errors use cool-warm, from blue (too dark) through grey to red (too bright). docs/references.md
#pragma once
#include <span>
#include <string>

#include "core/image/image.h"

namespace neph {

struct ErrorScale {
    double most = 1.0;       ///< error at the end of the bar; larger ones get its colour
    bool bothSigns = false;  ///< the bar starts at -most; otherwise at 0, and signs are ignored
    bool percent = true;     ///< the labels are in percent, an error of 1 being 100 %
    std::string title{};     ///< left of the bar: "|A-B|/B"; only characters of the font
};

/// Colour of an error, sRGB in [0, 1].
glm::vec3 errorColour(double error, const ErrorScale& scale);

/// The smallest 1, 2 or 5 times a power of ten that 99 % of the magnitudes do not exceed; at least
/// 0.1 %.
double roundEnd(std::span<const float> errors);

/// The errors of an image of `size`, row 0 on top, as colours.
Image8 errorColours(glm::ivec2 size, std::span<const float> errors, const ErrorScale& scale);

/// The same with a labelled colour bar below it.
Image8 errorImage(glm::ivec2 size, std::span<const float> errors, const ErrorScale& scale);

}  // namespace neph
