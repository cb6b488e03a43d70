// theme.h: a calm dark look for the panels, so that the picture is the brightest thing on screen.
#pragma once

namespace neph::ui {

/// Colours and spacing of the current ImGui context; `scale` is 1 at 96 dpi.
void applyTheme(float scale);

/// Loads a readable proportional font, or keeps the built-in one where none is installed.
void loadFont(float scale);

}  // namespace neph::ui
