// camera_tools.h: what the camera's panel and its flight keep between frames.
#pragma once
#include <string>

#include "app/ui/camera/sun_drag.h"

namespace neph::ui {

struct CameraTools {
    bool flying = false;      ///< the mouse looks around and keys move the eye
    bool fliesHeld = false;   ///< ... for as long as the right button is down
    bool moves = false;       ///< a key of flight was down in the last frame
    double flySpeed = 0.05;   ///< larger horizontal extents of the domain a second; tuned by eye
    bool outOfReach = false;  ///< the last number typed or step flown led beyond the bounds
    int renaming = -1;        ///< bookmark whose name is typed; -1: none
    std::string name;         ///< as typed
    bool leftTaken = false;   ///< a left drag over the image draws a line
    SunDrag sun;              ///< what of the sun the mouse is over or holds
};

}  // namespace neph::ui
