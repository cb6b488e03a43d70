// fields_panel.h: the hydrometeors: which are seen, in which colour, how much of each.
#pragma once
#include "app/ui/fields/fields_state.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

void drawFields(const PanelContext& context, FieldsState& state);

}  // namespace neph::ui
