// help_sheet.h: what mouse and keys do.
#pragma once

namespace neph::ui {

/// `shown` becomes false when the sheet is closed.
void drawHelp(bool& shown);

}  // namespace neph::ui
