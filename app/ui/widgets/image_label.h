// image_label.h: words on a plate over the image.
#pragma once
#include <imgui.h>

namespace neph::ui {

/// `at` is the plate's upper edge; `alignX`: 0 where its left end is, 0.5 its middle, 1 its right
/// end. `marked`: in the colour of what is edited.
void imageLabel(const char* text, ImVec2 at, float alignX, bool marked);

}  // namespace neph::ui
