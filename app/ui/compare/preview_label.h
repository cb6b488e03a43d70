// preview_label.h: says on an image that it is a denoised preview, as long as it is one.
#pragma once
#include <array>

#include "app/ui/compare/compare_state.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

/// Of the images of slots A and B, as of the last frame; the window says so.
struct PreviewMarks {
    std::array<bool, 2> possible{};  ///< its engine has halves to denoise by
    std::array<int, 2> samples{};    ///< per pixel, of which a preview is shown; 0: none is
};

/// Whether there is an image that can be denoised.
inline bool canPreview(const PreviewMarks& marks) {
    return marks.possible[0] || marks.possible[1];
}

/// In a corner of each image on screen that is a preview, apart from others' labels.
void drawPreviewLabels(const PanelContext& context, const CompareState& compare,
                       const PreviewMarks& marks);

}  // namespace neph::ui
