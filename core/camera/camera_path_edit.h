// camera_path_edit.h: changes of a camera path that keep its keys in order of time.
#pragma once
#include <cstddef>

#include "core/camera/camera_path.h"

namespace neph {

inline constexpr double kLeastStepS = 0.1;  ///< between two keys

/// Puts a key at a time of playing, in the place of one that is there within kLeastStepS. Returns
/// its index; none where the path has as many keys as a file may.
std::optional<std::size_t> insertKey(CameraPath& path, double atS, const CameraPose& pose);

/// Gives a key another time, as far as its neighbours let it go.
void setKeyTime(CameraPath& path, std::size_t index, double atS);

/// Lets two neighbours change places; their times stay.
void swapWithNext(CameraPath& path, std::size_t index);

/// Stretches all times, so that the path takes so long.
void setDuration(CameraPath& path, double durationS);

}  // namespace neph
