// action_button.h: a button of a panel that runs one of the program's actions.
#pragma once
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

/// `width` in pixels; `last` of its line.
void actionButton(const ActionLookup& actions, const char* id, const char* label, float width,
                  bool last);

}  // namespace neph::ui
