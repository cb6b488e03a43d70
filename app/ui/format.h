// format.h: numbers as the panels show them.
#pragma once
#include <string>

#include "core/look.h"

namespace neph::ui {

/// printf format of a parameter's value with its unit on screen: "%.3g um".
std::string sliderFormat(const Parameter& row);

/// The parameter's help, unit, range and default, for a tooltip.
std::string tooltipOf(const Parameter& row);

}  // namespace neph::ui
