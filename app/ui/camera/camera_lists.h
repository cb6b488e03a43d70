// camera_lists.h: the parts of the Camera panel that list places.
#pragma once
#include "app/ui/shell/ui.h"

namespace neph::ui {

void drawBookmarks(Ui& ui);
void drawPath(Ui& ui);

}  // namespace neph::ui
