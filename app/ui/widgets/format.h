// format.h: what tooltips say of a parameter, from its row of the look table.
#pragma once
#include <string>

#include "core/look/parameter.h"

namespace neph::ui {

/// Range, default, and the loaded preset's value where it is another: "1 µm to 10000 µm · default
/// 10 µm".
std::string factsOf(const Parameter& row, const Look& preset);

/// What a change is measured against: the preset's value, or the default where presets have none.
ParameterValue startingValue(const Parameter& row, const Look& preset);

/// What can be typed or pasted for a value: "id=value" in SI, or a value as the screen has it.
/// Throws Error.
ParameterValue pastedValue(const Parameter& row, std::string_view text);

}  // namespace neph::ui
