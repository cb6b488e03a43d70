// theme.h: colours, spacing and font of the panels: calm, so that the image is the brightest
// thing on the screen, or light, for bright rooms and for print.
#pragma once
#include <imgui.h>

#include "core/session/settings.h"

namespace neph::ui {

/// All of it, for a monitor of `scale` (1 at 96 dpi) and what the user chose. The font's texture is
/// then to be uploaded again.
void restyle(float scale, const Settings& settings);

/// Colours and spacing of the current ImGui context.
void applyTheme(float scale, Theme theme = Theme::dark);

/// Adds a readable proportional font with Greek, superscripts and arrows, or ImGui's own where none
/// is installed.
void loadFont(float scale);

/// Of words that tell of a limit or of a fault, on panels and notices.
ImVec4 warningColour();
ImVec4 errorColour();

}  // namespace neph::ui
