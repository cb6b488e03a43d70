// camera_path.h: places that a camera passes on its way, and places worth coming back to.
//
// Poses are as in the document, shares of the grid that is shown. Files: camera_format.h.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/camera/camera.h"

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

/// Where the path ends, seconds; 0 without keys.
double durationS(const CameraPath& path);

/// The camera at a time of playing: smooth between the keys, exactly theirs at their times, that of
/// the first before it and of the last after it. Where two keys share their target, the way between
/// is round it; where they share their eye, the eye stays. Default pose without keys.
CameraPose poseAt(const CameraPath& path, const RegularGrid& grid, double atS);

/// Which of `count` times of the data to show, each for the same share of the path; none where the
/// path leaves the time alone.
std::optional<int> timeAt(const CameraPath& path, double atS, int count);

}  // namespace neph
