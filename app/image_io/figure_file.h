// figure_file.h: plots as files: SVG for documents, PNG for screens.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/image_io/metadata.h"
#include "core/plot/canvas.h"
#include "core/plot/figure.h"

namespace neph {

/// A figure and where it is on the sheet.
struct PlacedFigure {
    plot::Figure figure;
    plot::RectPt area;
};

/// Several figures on one sheet, white ground.
struct Sheet {
    glm::dvec2 sizePt{800.0, 500.0};
    std::vector<PlacedFigure> figures;
    Metadata metadata;  ///< stored in the file
};

/// Writes SVG or, with two pixels per point, PNG, by the extension. Replaces the file at once.
/// Throws Error for any other extension, or where the file cannot be written.
void writeSheet(const std::filesystem::path& file, const Sheet& sheet);

}  // namespace neph
