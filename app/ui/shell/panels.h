// panels.h: the panels that draw() puts together; one file each.
#pragma once
#include "app/ui/shell/ui.h"

namespace neph::ui {

void moveCamera(Ui& ui);          ///< by what the mouse does on the picture
void drawMenuBar(Ui& ui);         ///< on top
void drawData(Ui& ui);            ///< left column: what is open
void drawFields(Ui& ui);          ///< below it: a row a field
void drawFind(Ui& ui);            ///< top of the right column: any parameter by name
void drawGroups(Ui& ui);          ///< right column: modes, light, sun and sky, view
void drawCamera(Ui& ui);          ///< in it: the camera in numbers, bookmarks and path
void drawCameraOverlays(Ui& ui);  ///< over the picture: scale, north, heights
void drawPresets(Ui& ui);         ///< in the right column
void drawPresetDetails(Ui& ui);   ///< what a preset would change; drawPresets has it
void drawPresetDialogs(Ui& ui);   ///< ask for names of presets
void playOn(Ui& ui);              ///< moves on where something is played
int lastTime(const Ui& ui);       ///< index of the last time of the data, 0 before any
void drawTimeBar(Ui& ui);         ///< below the columns
void drawStatus(Ui& ui);          ///< along the bottom
void drawNotices(Ui& ui);         ///< loading, errors, empty states; messages when asked for
void drawPalette(Ui& ui);         ///< finds actions and parameters
void drawHelp(Ui& ui);            ///< the table of actions
void drawHistory(Ui& ui);         ///< the list of steps
void drawPathPopup(Ui& ui);       ///< asks for files to open
void drawSessionDialogs(Ui& ui);  ///< data that have moved, what was opened lately
void drawOutput(Ui& ui);          ///< the export dialogue and the export that runs
void drawProfile(const Ui& ui);   ///< what the picture cost
void drawCompare(Ui& ui);         ///< the line between two slots' pictures, and peeking
void drawCompareErrors(Ui& ui);   ///< how far A is from B, as figures and as colours

/// Shows the part of the domain that holds the clouds that are seen, with a margin.
void showAroundClouds(Ui& ui);

/// Opens or closes a column. In a window too narrow for both, the one opened last is shown.
void openColumn(Ui& ui, bool left, bool open);

/// Opens a fixed borderless window; pair with ImGui::End().
bool beginFixed(const char* name, glm::vec2 at, glm::vec2 size);

}  // namespace neph::ui
