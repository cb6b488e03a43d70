// camera_format.h: the JSON format of cameras and camera paths in presets, sessions and separate
// files.
//
// A camera is {"target": [x, y, z], "distance", "azimuth_deg", "elevation_deg", "fov_deg"} and,
// where it does not follow a grid that moves, "fixed_to_ground": true; a path {"type":
// "nephoscope-camera-path", "version": 1, "with_time": true, "keys": [{"at_s": 0, "camera": {...}},
// ...]}. Functions exchange text, so that headers need no JSON library.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/camera/camera.h"
#include "core/camera/camera_path.h"

namespace neph {

/// A number of the camera object; the only place where its key and range are written.
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

inline constexpr std::string_view kFixedKey = "fixed_to_ground";

inline constexpr std::string_view kPathType = "nephoscope-camera-path";
inline constexpr int kPathVersion = 1;
inline constexpr std::size_t kMaxPathKeys = 1000;  ///< more than a path of one minute needs
inline constexpr double kMaxPathS = 86400.0;       ///< a day

/// The camera object on one line; reading it back gives the same bits.
std::string formatCamera(const CameraPose& pose);

/// Reads a camera object; `where` starts the messages. Missing keys get their defaults, unknown
/// ones are reported in `warnings`. Throws Error naming key, value and range.
CameraPose parseCamera(std::string_view json, std::string_view where,
                       std::vector<std::string>& warnings);

/// A complete path object, one key per line; reading it back gives the same bits.
std::string formatCameraPath(const CameraPath& path);

/// Reads a path object: at most kMaxPathKeys keys with increasing times from 0 to kMaxPathS. Throws
/// Error.
CameraPath parseCameraPath(std::string_view json, std::string_view where,
                           std::vector<std::string>& warnings);

/// Reads a path file. Throws Error; unknown keys are added to `warnings`.
CameraPath loadCameraPath(const std::filesystem::path& file, std::vector<std::string>& warnings);

/// Replaces the file. Throws Error if it cannot be written.
void saveCameraPath(const std::filesystem::path& file, const CameraPath& path);

}  // namespace neph
