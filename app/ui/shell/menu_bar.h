// menu_bar.h: the actions as menus, along the top of the window.
#pragma once
#include "app/ui/shell/ui.h"

namespace neph::ui {

void drawMenuBar(Ui& ui);

}  // namespace neph::ui
