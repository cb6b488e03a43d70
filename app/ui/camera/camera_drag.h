// camera_drag.h: the camera follows what the mouse does on the image, and the keys of flight.
#pragma once
#include "app/ui/camera/camera_tools.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

/// Once per frame, before what is drawn for the camera's place.
void moveCamera(const PanelContext& context, CameraTools& tools);

}  // namespace neph::ui
