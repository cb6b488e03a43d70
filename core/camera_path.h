// camera_path.h: places that a camera passes on its way, and places worth coming back to.
//
// Poses are as in the document, shares of the grid that is shown.
#pragma once
#include <string>
#include <vector>

#include "core/camera.h"

namespace neph {

struct Bookmark {
    std::string name;
    CameraPose pose;
    bool operator==(const Bookmark&) const = default;
};

struct PathKey {
    double atS = 0.0;  ///< seconds of playing since the start of the path
    CameraPose pose;
    bool operator==(const PathKey&) const = default;
};

/// A path through its keys, which are in order of time.
struct CameraPath {
    std::vector<PathKey> keys;
    bool withTime = true;  ///< played from the first to the last time of the data as well
    bool operator==(const CameraPath&) const = default;
};

}  // namespace neph
