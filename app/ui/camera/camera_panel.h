// camera_panel.h: the camera in numbers, its bookmarks and its path.
#pragma once
#include "app/ui/camera/camera_tools.h"
#include "app/ui/panel/panel_context.h"
#include "app/ui/time/playback.h"

namespace neph::ui {

void drawCamera(const PanelContext& context, CameraTools& tools, Playback& playback);

}  // namespace neph::ui
