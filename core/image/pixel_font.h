// pixel_font.h: text and rectangles in 8-bit images, so that legends need no font file.
//
// Letters are 5 by 7 units, a unit being a square of pixels. What lies outside an image is clipped.
#pragma once
#include <glm/glm.hpp>
#include <string_view>

#include "core/image/image.h"

namespace neph {

inline constexpr int kLetterHeight = 7;  ///< units

/// Pixels from the left edge of the first letter to the right edge of the last.
int pixelWidthOf(std::string_view text, int unit);

/// Fills a rectangle; colours are 8-bit sRGB.
void fillPixels(Image8& image, glm::ivec2 from, glm::ivec2 size, const glm::ivec3& colour);

/// Writes text with its upper left corner at `at`. Letters that the font lacks are blank.
void writePixels(Image8& image, glm::ivec2 at, int unit, std::string_view text,
                 const glm::ivec3& colour);

}  // namespace neph
