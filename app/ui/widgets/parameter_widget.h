// parameter_widget.h: the one widget there is for a parameter; everything about it comes from its
// row.
//
// `preset` is the look of the preset that was loaded last: what differs from it is marked, and a
// double click on the label goes back to it; sampling, which presets do not hold, to the default.
#pragma once
#include <string>

#include "core/look/parameter.h"

namespace neph::ui {

/// Label and editor on one line, with a mark, a tooltip and a menu to reset, copy and paste. True
/// when the value changed.
bool parameterWidget(const Parameter& row, ParameterSet& values, const Look& preset);

/// The label alone, in the panel's own words: a double click resets the value; with tooltip and
/// menu.
bool parameterLabel(const Parameter& row, const std::string& text, ParameterSet& values,
                    const Look& preset);

/// The editor alone, as wide as ImGui's next item: slider, switch, choice or swatch; with tooltip
/// and menu.
bool parameterEditor(const Parameter& row, ParameterSet& values, const Look& preset);

/// Tooltip and menu for the last item, where a panel draws the editor itself.
bool parameterExtras(const Parameter& row, ParameterSet& values, const Look& preset);

/// The dot that says that a value is not the preset's, left of where the next item stands.
void changedMark(const Parameter& row, const ParameterSet& values, const Look& preset);

}  // namespace neph::ui
