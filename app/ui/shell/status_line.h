// status_line.h: the newest message and the figures of the frame, along the bottom of the window.
#pragma once
#include "app/ui/panel/frame_report.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

/// A click on the message shows or hides the list of all.
void drawStatus(const PanelContext& context, const FrameReport& report, bool& showMessages);

}  // namespace neph::ui
