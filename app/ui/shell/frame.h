// frame.h: one frame of the window's panels.
#pragma once
#include "app/ui/shell/ui.h"

namespace neph::ui {

/// Camera under the mouse, menus, columns, time bar, status line, popups. Call between NewFrame and
/// Render.
void draw(Ui& ui);

}  // namespace neph::ui
