// groups_panel.h: parameters that belong to no field, by groups, and any parameter by its name.
#pragma once
#include "app/ui/fields/fields_state.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

/// A line to type in, and below it the parameters that it finds.
void drawFind(const PanelContext& context, FieldsState& state);

/// Modes, light, sun and sky, view.
void drawGroups(const PanelContext& context);

}  // namespace neph::ui
