// preset_dialogs.h: dialogues that ask for names and words of presets.
#pragma once
#include "app/ui/panel/panel_context.h"
#include "app/ui/presets/preset_state.h"

namespace neph::ui {

void drawPresetDialogs(const PanelContext& context, PresetBrowser& presets);

}  // namespace neph::ui
