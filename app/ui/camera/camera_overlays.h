// camera_overlays.h: scale, north and heights over the image, and how flight goes.
#pragma once
#include "app/ui/camera/camera_tools.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

void drawCameraOverlays(const PanelContext& context, const CameraTools& tools);

}  // namespace neph::ui
