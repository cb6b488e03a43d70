// sun_tools.h: the sun of the image above its parameters: what it follows from, and three buttons.
#pragma once
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

void drawSunTools(const PanelContext& context);

}  // namespace neph::ui
