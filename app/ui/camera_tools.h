// camera_tools.h: what the camera's panel and overlays keep between frames.
#pragma once

namespace neph::ui {

struct CameraTools {};

}  // namespace neph::ui
