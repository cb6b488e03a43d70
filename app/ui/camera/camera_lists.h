// camera_lists.h: the parts of the Camera panel that list places.
#pragma once
#include "app/ui/camera/camera_tools.h"
#include "app/ui/panel/panel_context.h"
#include "app/ui/time/playback.h"

namespace neph::ui {

void drawBookmarks(const PanelContext& context, CameraTools& tools);
void drawPath(const PanelContext& context, Playback& playback);

}  // namespace neph::ui
