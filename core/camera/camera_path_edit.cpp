// camera_path_edit.cpp: adds and moves keys within the limits of the file format.
#include "core/camera/camera_path_edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/camera/camera_format.h"

namespace neph {

std::optional<std::size_t> insertKey(CameraPath& path, double atS, const CameraPose& pose) {
    atS = std::clamp(atS, 0.0, kMaxPathS);
    for (std::size_t i = 0; i < path.keys.size(); ++i) {
        if (std::abs(path.keys[i].atS - atS) >= kLeastStepS) continue;
        path.keys[i].pose = pose;
        return i;
    }
    if (path.keys.size() >= kMaxPathKeys) return {};
    const auto after = std::ranges::upper_bound(path.keys, atS, {}, &PathKey::atS);
    const auto index = static_cast<std::size_t>(after - path.keys.begin());
    path.keys.insert(after, {atS, pose});
    return index;
}

void setKeyTime(CameraPath& path, std::size_t index, double atS) {
    const double least = index == 0 ? 0.0 : path.keys[index - 1].atS + kLeastStepS;
    const double most =
        index + 1 == path.keys.size() ? kMaxPathS : path.keys[index + 1].atS - kLeastStepS;
    if (least <= most) path.keys[index].atS = std::clamp(atS, least, most);
}

void swapWithNext(CameraPath& path, std::size_t index) {
    if (index + 1 < path.keys.size()) std::swap(path.keys[index].pose, path.keys[index + 1].pose);
}

void setDuration(CameraPath& path, double durationS) {
    if (path.keys.empty() || path.keys.back().atS <= 0.0) return;
    double closest = path.keys.back().atS;
    for (std::size_t i = 1; i < path.keys.size(); ++i) {
        closest = std::min(closest, path.keys[i].atS - path.keys[i - 1].atS);
    }
    const double whole = path.keys.back().atS;
    // Keys do not come closer than the least step, or than they were.
    const double least = whole * std::min(1.0, kLeastStepS / closest);
    const double scale = std::clamp(durationS, least, kMaxPathS) / whole;
    for (PathKey& key : path.keys) key.atS *= scale;
    path.keys.back().atS = std::min(path.keys.back().atS, kMaxPathS);
}

}  // namespace neph
