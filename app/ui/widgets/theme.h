// theme.h: colours, spacing and font of the panels: calm, so that the image is the brightest
// thing on the screen, or light, for bright rooms and for print.
#pragma once
#include <imgui.h>

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "core/session/settings.h"

namespace neph::ui {

/// All of it, for a monitor of `scale` (1 at 96 dpi) and what the user chose. The font's texture is
/// then to be uploaded again.
void restyle(float scale, const Settings& settings);

/// Colours and spacing of the current ImGui context.
void applyTheme(float scale, Theme theme = Theme::dark);

/// Adds a readable proportional font with Greek, superscripts and arrows, or ImGui's own where none
/// is installed; and what wantGlyphs() asked for, as far as any font of the system has it.
void loadFont(float scale);

/// Asks for the letters of a text that is about to be shown, such as a file's name in Chinese.
void wantGlyphs(std::string_view text);

/// Whether letters were asked for since the font was loaded: it is to be loaded again.
bool lacksGlyphs();

/// Fonts for Chinese, Japanese and Korean in these folders, or below them where systems put them:
/// one that has all three scripts, else all that there are.
std::vector<std::filesystem::path> eastAsianFonts(std::span<const std::filesystem::path> folders);

/// Of words that tell of a limit or of a fault, on panels and notices.
ImVec4 warningColour();
ImVec4 errorColour();

}  // namespace neph::ui
