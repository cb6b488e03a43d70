// parameter_widget.h: the one widget there is for a parameter; everything about it comes from its
// row.
#pragma once
#include "core/look.h"

namespace neph::ui {

/// Label and editor on one line, with tooltip and a menu to reset; double click on the label resets
/// too. True when the value changed.
bool parameterWidget(const Parameter& row, Look& look);

/// The editor alone, as wide as ImGui's next item: slider, switch, choice or swatch.
bool parameterEditor(const Parameter& row, Look& look);

}  // namespace neph::ui
