// error_colours.h: errors as colours in the place of the image, with what the colours mean.
#pragma once
#include "app/ui/widgets/area.h"
#include "core/image/error_image.h"

namespace neph::ui {

/// `texture` over all of `area`, and a colour bar of both signs below it, under which `meaning`
/// stands: "(A - B) / B".
void drawErrorColours(const Area& area, unsigned texture, const ErrorScale& scale,
                      const char* meaning);

}  // namespace neph::ui
