// compare_figures.h: how far A is from B, as figures and as colours.
#pragma once
#include "app/ui/compare/compare_errors.h"
#include "app/ui/compare/compare_state.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

void drawCompareErrors(const PanelContext& context, const CompareState& compare,
                       CompareErrors& errors);

}  // namespace neph::ui
