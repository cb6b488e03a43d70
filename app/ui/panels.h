// panels.h: the panels that draw() puts together; one file each.
#pragma once
#include "app/ui/ui.h"

namespace neph::ui {

void moveCamera(Ui& ui);         ///< by what the mouse does on the picture
void drawFields(Ui& ui);         ///< left column: a row a field
void drawData(Ui& ui);           ///< below the fields
void drawGroups(Ui& ui);         ///< right column: modes, light, sun and sky, view
void drawPresets(Ui& ui);        ///< in the right column
void drawTimeBar(Ui& ui);        ///< between the columns
void drawStatus(Ui& ui);         ///< along the bottom
void drawNotices(Ui& ui);        ///< loading, errors, empty states; messages when asked for
void drawHelp(Ui& ui);           ///< the table of actions
void drawPathPopup(Ui& ui);      ///< asks for files to open
void drawProfile(const Ui& ui);  ///< what the picture cost

/// Shows the part of the domain that holds the clouds that are seen, with a margin.
void showAroundClouds(Ui& ui);

/// Opens a fixed borderless window; pair with ImGui::End().
bool beginFixed(const char* name, glm::vec2 at, glm::vec2 size);

}  // namespace neph::ui
