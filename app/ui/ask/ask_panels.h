// ask_panels.h: windows with the answers: a column, a section, a series.
#pragma once
#include "app/ui/ask/ask_state.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

void drawColumnPanel(const PanelContext& context, AskState& ask, bool& shown);
void drawSectionPanel(const PanelContext& context, AskState& ask, bool& shown);
void drawPinsPanel(const PanelContext& context, AskState& ask, bool& shown);
void drawSeriesPanel(const PanelContext& context, AskState& ask, bool& shown);

}  // namespace neph::ui
