// preset_format.h: how a preset is spelled in its file; shared by its reader and its writer.
#pragma once
#include <array>
#include <string_view>

#include "core/camera.h"

namespace neph {

inline constexpr std::string_view kPresetType = "nephoscope-look";
inline constexpr int kPresetVersion = 1;

/// A number of the camera object: the single spelling of its key and range.
struct CameraKey {
    std::string_view key;
    float CameraPose::*member;
    float lo, hi;
};
inline constexpr std::array kCameraKeys{
    CameraKey{"distance", &CameraPose::distance, kMinDistance, kMaxDistance},
    CameraKey{"azimuth_deg", &CameraPose::azimuthDeg, -360.0f, 360.0f},
    CameraKey{"elevation_deg", &CameraPose::elevationDeg, -90.0f, 90.0f},
    CameraKey{"fov_deg", &CameraPose::fovDeg, kMinFovDeg, kMaxFovDeg},
};

}  // namespace neph
