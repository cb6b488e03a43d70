// preset_browser.h: presets as cards to choose from.
#pragma once
#include "app/ui/panel/panel_context.h"
#include "app/ui/presets/preset_state.h"

namespace neph::ui {

void drawPresets(const PanelContext& context, PresetBrowser& presets);

}  // namespace neph::ui
