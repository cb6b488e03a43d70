// context.h: what the shell hands to panels: their context, and what they depend on of other rooms.
#pragma once
#include "app/ui/output/output_plan.h"
#include "app/ui/shell/ui.h"

namespace neph::ui {

/// Refers to `ui`, for as long as that lives.
PanelContext contextOf(Ui& ui);

/// What an export of the window depends on.
ExportScene exportSceneOf(const Ui& ui);

/// Time of the data in the image that is shown. -1: of two images, or the other slot's, that is not
/// known.
int imageTimeOf(const Ui& ui);

}  // namespace neph::ui
