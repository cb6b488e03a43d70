// camera.h: the viewpoint of the image.
//
// A CameraPose is part of the document and independent of any data set: lengths are shares of the
// domain's larger horizontal extent and heights shares of its depth, so that the camera of a preset
// suits any storm. A Camera is a pose placed in a world in metres.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "core/grid/grid.h"

namespace neph {

/// Where the camera is and what it looks at, relative to the domain.
struct CameraPose {
    glm::vec3 target{0.5f, 0.5f, 0.35f};  ///< share of the domain in x, y and z
    float distance = 1.1f;                ///< eye to target, in larger horizontal extents
    float azimuthDeg = 180.0f;   ///< direction from the target to the eye, clockwise from north
    float elevationDeg = 12.0f;  ///< of the eye above the horizon of the target
    float fovDeg = 40.0f;        ///< vertical field of view
    /// Eye and target stay where they are on the ground while the grid moves: see keepOnGround().
    bool fixedToGround = false;
    bool operator==(const CameraPose&) const = default;
};

inline constexpr float kMinFovDeg = 5.0f, kMaxFovDeg = 75.0f;
inline constexpr float kMinDistance = 1e-3f, kMaxDistance = 20.0f;
inline constexpr float kMinTarget = -1.0f, kMaxTarget = 2.0f;  // in height
/// Across, where a domain may repeat to the horizon, and a grid that moves leaves behind what is
/// fixed to the ground: 4000 km of one of 40 km, with a precision of half a metre.
inline constexpr float kFarTarget = 100.0f;

/// What the target of a pose can be, shares of the domain.
struct TargetLimits {
    glm::vec3 lower{-kFarTarget, -kFarTarget, kMinTarget};
    glm::vec3 upper{kFarTarget, kFarTarget, kMaxTarget};
    glm::vec3 nearest(const glm::vec3& target) const { return glm::clamp(target, lower, upper); }
};

/// A camera in world space, ready for rendering; axes are orthonormal.
struct Camera {
    glm::dvec3 eyeWorld{0.0};
    glm::dvec3 forward{0.0, 1.0, 0.0};  ///< unit, as are right and up
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double tanHalfFovY = 0.4;
    double aspect = 1.0;  ///< width / height

    /// Unit direction of the ray through a point of the image; ndc in [-1, 1], y up.
    glm::dvec3 rayDir(glm::dvec2 ndc) const;
};

/// The pose in the world of `grid`.
Camera placeCamera(const CameraPose& pose, const RegularGrid& grid, double aspect);

/// The pose in `to` with the same view as `pose` in `from`; empty if that is outside the limits of
/// a pose.
std::optional<CameraPose> sameView(const CameraPose& pose, const RegularGrid& from,
                                   const RegularGrid& to);

/// After `grid` has moved by metres over the ground: a pose that is fixed to it sees the same place
/// as before.
void keepOnGround(CameraPose& pose, const RegularGrid& grid, glm::dvec2 movedM);

/// Rotates the eye around the target; avoids the poles.
void orbit(CameraPose& pose, float azimuthStepDeg, float elevationStepDeg);

/// Moves the target in the image plane, in units of the image height.
void pan(CameraPose& pose, const RegularGrid& grid, glm::vec2 step);

/// Multiplies the distance, within its limits.
void dolly(CameraPose& pose, float factor);

}  // namespace neph
