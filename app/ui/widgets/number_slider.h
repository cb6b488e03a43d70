// number_slider.h: a slider for numbers that can be dragged finely, and typed into.
#pragma once
#include <string>

namespace neph::ui {

struct NumberRange {
    double lo = 0.0, hi = 1.0;
    bool log = false;  ///< by decades; where `lo` is 0 that is the left stop, and five decades more
    bool whole = false;
};

/// As wide as ImGui's next item; `value` and `range` are in the units of the screen, `text` is the
/// value as it is to be read and `unit` what may follow a typed number. A drag with Shift moves a
/// tenth as far, Ctrl+click types, the wheel does nothing. True when the value changed, always to
/// one of the range.
bool numberSlider(const char* id, double& value, const NumberRange& range, const std::string& text,
                  const std::string& unit);

}  // namespace neph::ui
