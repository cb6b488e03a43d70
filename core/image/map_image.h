// map_image.h: a field on a grid as an image: axes in kilometres, title and a labelled colour bar.
//
// 8-bit sRGB, the colour map magma from 0 to the end of the bar; north is up.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string>

#include "core/image/image.h"

namespace neph {

/// What is drawn.
struct MapField {
    glm::ivec2 size{0};             ///< columns in x and y
    std::span<const float> values;  ///< x fastest, y from south to north; NaN: not known
    glm::dvec2 originKm{0.0};       ///< lower corner of the first column
    glm::dvec2 cellKm{1.0};
    int widthPx = 480;  ///< of the map, as far as whole pixels per cell allow; at least one each
    double most = 1.0;  ///< value at the end of the colour bar; larger ones get its colour
    std::string title{}, subtitle{};  ///< above the map
    std::string label{};              ///< of the colour bar
};

/// The drawing, and where in it the map itself is: pixels, from the upper left corner.
struct MapImage {
    Image8 image;
    glm::ivec2 mapAtPx{0}, mapSizePx{0};
    /// Column under a pixel of the image, -1 where there is none.
    glm::ivec2 columnAt(glm::dvec2 pixel, glm::ivec2 size) const;
};

MapImage drawMap(const MapField& field);

/// The smallest of 1, 2 or 5 times a power of ten that no value exceeds; 1 where all are 0.
double roundMost(std::span<const float> values);

}  // namespace neph
