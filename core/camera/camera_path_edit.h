// camera_path_edit.h: edits of a camera path that keep its keys sorted by time.
#pragma once
#include <cstddef>

#include "core/camera/camera_path.h"

namespace neph {

inline constexpr double kLeastStepS = 0.1;  ///< between two keys

/// Adds a key at a playback time, or replaces one within kLeastStepS of it. Returns its index;
/// empty if the path has as many keys as a file may have.
std::optional<std::size_t> insertKey(CameraPath& path, double atS, const CameraPose& pose);

/// Moves a key to another time, as far as its neighbours allow.
void setKeyTime(CameraPath& path, std::size_t index, double atS);

/// Swaps the poses of two neighbouring keys; their times stay.
void swapWithNext(CameraPath& path, std::size_t index);

/// Scales all times so that the path has this duration.
void setDuration(CameraPath& path, double durationS);

}  // namespace neph
