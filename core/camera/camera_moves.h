// camera_moves.h: what hands and commands do with a camera besides orbit, pan and dolly: zoom to
// what is under the cursor, fly, stand at a place, and look from a side with all in the picture.
//
// Points are metres in world space (grid.h). A move that would leave the bounds of a pose is not
// made, and says so by false or nothing.
#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "core/camera/camera.h"
#include "core/volume/read_plan.h"

namespace neph {

/// Multiplies the distance, within bounds. What is seen at `ndc` (in [-1, 1], y up) and as far away
/// as the target stays there.
void zoomTo(CameraPose& pose, const RegularGrid& grid, glm::dvec2 ndc, double aspect, float factor);

/// Puts the eye at a place, with the direction, the field of view and, where the target's bounds
/// allow it, the distance of the pose.
bool standAt(CameraPose& pose, const RegularGrid& grid, const glm::dvec3& eyeM);

/// Moves eye and target by metres to the right, towards the zenith, and forwards.
bool fly(CameraPose& pose, const RegularGrid& grid, const glm::dvec3& stepM);

/// Turns the view about the eye: to the right, and upwards. Keeps clear of the poles.
bool lookAround(CameraPose& pose, const RegularGrid& grid, float rightDeg, float upDeg);

/// Somebody who stands in the domain and looks at the sky: a camera told by eye and view.
struct Observer {
    double eastM = 0.0, northM = 0.0;  ///< from the south-west corner of the domain
    double heightM = 2.0;              ///< above sea level, where pictures have their ground
    double azimuthDeg = 0.0;           ///< of the view, north to east
    double elevationDeg = 0.0;         ///< of the view above the horizon
    double fovDeg = 40.0;              ///< vertical
    bool operator==(const Observer&) const = default;
};

Observer observerOf(const CameraPose& pose, const RegularGrid& grid);

/// The target is the point of the view that is nearest to the middle of the domain. None where the
/// eye is further from the domain than poses reach.
std::optional<CameraPose> poseOf(const Observer& observer, const RegularGrid& grid);

/// Sides to look from: from above with north on top, from the four winds, and from below. `fit`
/// keeps the direction.
enum class View : int { fit, plan, north, east, south, west, below };
inline constexpr std::array<std::string_view, 7> kViewNames{"fit",   "plan", "north", "east",
                                                            "south", "west", "below"};

/// `pose` turned to a side, with all of `box` in a picture of this aspect as large as it can be but
/// for a margin. Farther than poses reach it is as far as they do.
CameraPose viewOf(View view, CameraPose pose, const RegularGrid& grid, const Region& box,
                  double aspect);

/// Where a point is in the picture, in [-1, 1] when inside; none when it is not before the eye.
std::optional<glm::dvec2> ndcOf(const Camera& camera, const glm::dvec3& pointM);

}  // namespace neph
