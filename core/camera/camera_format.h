// camera_format.h: how cameras and camera paths are spelled in files: presets, sessions and files
// of their own.
//
// A camera is {"target": [x, y, z], "distance", "azimuth_deg", "elevation_deg", "fov_deg"}, a path
// {"type": "nephoscope-camera-path", "version": 1, "with_time": true, "keys": [{"at_s": 0,
// "camera": {...}}, ...]}. Text goes in and out, so that headers stay free of JSON.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/camera/camera.h"
#include "core/camera/camera_path.h"

namespace neph {

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

inline constexpr std::string_view kPathType = "nephoscope-camera-path";
inline constexpr int kPathVersion = 1;
inline constexpr std::size_t kMaxPathKeys = 1000;  ///< a minute has fewer
inline constexpr double kMaxPathS = 86400.0;       ///< a day

/// The camera object on one line; reads back bit for bit.
std::string formatCamera(const CameraPose& pose);

/// Reads a camera object; `where` opens the messages. Missing keys take their defaults, unknown
/// ones are told in `warnings`. Throws Error naming key, value and range.
CameraPose parseCamera(std::string_view json, std::string_view where,
                       std::vector<std::string>& warnings);

/// A whole path object, a key of the path a line; reads back bit for bit.
std::string formatCameraPath(const CameraPath& path);

/// Reads a path object: at most kMaxPathKeys keys, their times rising from 0 or later to kMaxPathS
/// at most. Throws Error.
CameraPath parseCameraPath(std::string_view json, std::string_view where,
                           std::vector<std::string>& warnings);

/// A path from a file of its own. Throws Error; what was unknown is added to `warnings`.
CameraPath loadCameraPath(const std::filesystem::path& file, std::vector<std::string>& warnings);

/// Writes aside and renames. Throws Error when the place cannot be written.
void saveCameraPath(const std::filesystem::path& file, const CameraPath& path);

}  // namespace neph
