// preset_details.h: what a preset would change, and parts of it to apply.
#pragma once
#include "app/ui/presets/preset_state.h"
#include "core/session/session.h"

namespace neph::ui {

void drawPresetDetails(Session& session, PresetBrowser& presets);

}  // namespace neph::ui
