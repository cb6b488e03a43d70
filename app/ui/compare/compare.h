// compare.h: the line between two slots' images, and peeking at the other one.
#pragma once
#include "app/ui/compare/compare_errors.h"
#include "app/ui/compare/compare_state.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

void drawCompare(const PanelContext& context, CompareState& compare, CompareErrors& errors);

}  // namespace neph::ui
