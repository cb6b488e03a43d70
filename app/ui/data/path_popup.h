// path_popup.h: asks for files to open.
#pragma once
#include "app/ui/data/session_files.h"

namespace neph::ui {

void drawPathPopup(const PanelContext& context, SessionDialogs& dialogs);

}  // namespace neph::ui
