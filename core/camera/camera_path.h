// camera_path.h: camera paths, and bookmarks of single poses.
//
// Poses are as in the document, relative to the grid that is shown. Files: camera_format.h.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/camera/camera.h"

namespace neph {

/// A named pose to return to.
struct Bookmark {
    std::string name;
    CameraPose pose;
    bool operator==(const Bookmark&) const = default;
};

/// A pose that the camera has at a playback time.
struct PathKey {
    double atS = 0.0;  ///< seconds of playback since the start of the path
    CameraPose pose;
    bool operator==(const PathKey&) const = default;
};

/// A path through its keys, which are sorted by time.
struct CameraPath {
    std::vector<PathKey> keys;
    bool withTime = true;  ///< also plays the times of the data, from first to last
    bool operator==(const CameraPath&) const = default;
};

/// Duration of the path, seconds; 0 without keys.
double durationS(const CameraPath& path);

/// The camera at a playback time: smooth between the keys, exactly theirs at their times, that of
/// the first before it and of the last after it. Between two keys with the same target the eye
/// moves around it; between two with the same eye the eye stays. Fixed to the ground where its
/// first key is. Default pose without keys.
CameraPose poseAt(const CameraPath& path, const RegularGrid& grid, double atS);

/// After `grid` has moved by metres over the ground: a path that is fixed to it leads along the
/// same places as before, and all its keys are fixed.
void keepOnGround(CameraPath& path, const RegularGrid& grid, glm::dvec2 movedM);

/// Which of `count` times of the data to show, each for an equal part of the path; empty if the
/// path does not play the times.
std::optional<int> timeAt(const CameraPath& path, double atS, int count);

}  // namespace neph
