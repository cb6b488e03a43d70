// transport_icons.h: the signs on the buttons of the time bar, drawn, because no font has them all.
#pragma once

namespace neph::ui {

enum class Icon { first, before, play, pause, after, last, loop };

/// A button with a sign on it; `lit` as a switch that is on.
bool iconButton(const char* id, Icon icon, float width, bool lit);

}  // namespace neph::ui
