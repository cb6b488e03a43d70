// format.h: numbers and tooltips as the panels show them, from the rows of the look table.
#pragma once
#include <string>

#include "core/look.h"

namespace neph::ui {

/// printf format of a parameter's value on screen, with its unit.
std::string sliderFormat(const Parameter& row);

/// Help, range, default and id.
std::string tooltipOf(const Parameter& row);

}  // namespace neph::ui
