// palette.h: finds actions and parameters by parts of their names, and runs or shows them.
#pragma once
#include "app/ui/shell/ui.h"

namespace neph::ui {

void drawPalette(Ui& ui);

}  // namespace neph::ui
