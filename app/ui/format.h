// format.h: numbers, units and tooltips as the panels show them, from the rows of the look table.
#pragma once
#include <string>
#include <string_view>

#include "core/look.h"

namespace neph::ui {

/// A unit as it is written on screen: "um" is µm, "kg m-3" kg/m³; empty for pure numbers.
std::string unitOnScreen(std::string_view unit);

/// printf format of a parameter's value on screen, with its unit.
std::string sliderFormat(const Parameter& row);

/// Help, range, default and id.
std::string tooltipOf(const Parameter& row);

/// Whether a row acts at present: a parameter of a phase function acts where its kind has it.
bool applies(const Parameter& row, const Look& look);

}  // namespace neph::ui
