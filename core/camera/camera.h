// camera.h: where the picture is taken from.
//
// A CameraPose is part of the document and knows no data set: lengths are shares of the domain's
// larger horizontal extent and heights shares of its depth, so that a preset's camera suits any
// storm. A Camera is a pose put into a world in metres.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "core/grid/grid.h"

namespace neph {

struct CameraPose {
    glm::vec3 target{0.5f, 0.5f, 0.35f};  ///< share of the domain in x, y and z
    float distance = 1.1f;                ///< eye to target, in larger horizontal extents
    float azimuthDeg = 180.0f;            ///< of the eye seen from the target, north to east
    float elevationDeg = 12.0f;           ///< height of the eye above the target's horizon
    float fovDeg = 40.0f;                 ///< vertical field of view
    bool operator==(const CameraPose&) const = default;
};

inline constexpr float kMinFovDeg = 5.0f, kMaxFovDeg = 75.0f;
inline constexpr float kMinDistance = 1e-3f, kMaxDistance = 20.0f;
inline constexpr float kMinTarget = -1.0f, kMaxTarget = 2.0f;  ///< as far as pan() goes

struct Camera {
    glm::dvec3 eyeWorld{0.0};
    glm::dvec3 forward{0.0, 1.0, 0.0};  ///< unit, as are right and up
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double tanHalfFovY = 0.4;
    double aspect = 1.0;  ///< width / height

    /// Unit direction of the ray through a point of the picture; ndc in [-1, 1], y up.
    glm::dvec3 rayDir(glm::dvec2 ndc) const;
};

/// The pose in the world of `grid`.
Camera placeCamera(const CameraPose& pose, const RegularGrid& grid, double aspect);

/// The pose in `to` that gives the view of `pose` in `from`; none where it is beyond the bounds.
std::optional<CameraPose> sameView(const CameraPose& pose, const RegularGrid& from,
                                   const RegularGrid& to);

/// Turns around the target; keeps clear of the poles.
void orbit(CameraPose& pose, float azimuthStepDeg, float elevationStepDeg);

/// Moves the target in the picture plane by shares of the picture's height.
void pan(CameraPose& pose, const RegularGrid& grid, glm::vec2 step);

/// Multiplies the distance, within bounds.
void dolly(CameraPose& pose, float factor);

}  // namespace neph
