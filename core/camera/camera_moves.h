// camera_moves.h: camera moves other than orbit, pan and dolly: zoom to the cursor, fly, stand at a
// place, and look from a side with everything in the image.
//
// Points are metres in world space (grid.h). A move that would leave the limits of a pose is not
// made; the function then returns false or an empty optional.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "core/camera/camera.h"
#include "core/grid/boxes.h"

namespace neph {

/// Multiplies the distance, within its limits. The point seen at `ndc` (in [-1, 1], y up) at the
/// distance of the target keeps its place in the image.
void zoomTo(CameraPose& pose, const RegularGrid& grid, glm::dvec2 ndc, double aspect, float factor);

/// Moves the eye to a place and keeps direction, field of view and, where the limits of the target
/// allow it, the distance of the pose.
bool standAt(CameraPose& pose, const RegularGrid& grid, const glm::dvec3& eyeM);

/// Moves eye and target by metres to the right, up, and forward.
bool fly(CameraPose& pose, const RegularGrid& grid, const glm::dvec3& stepM);

/// Rotates the view about the eye, to the right and up. Avoids the poles.
bool lookAround(CameraPose& pose, const RegularGrid& grid, float rightDeg, float upDeg);

/// A person standing in the domain and looking at the sky: a camera given by eye and direction.
struct Observer {
    double eastM = 0.0, northM = 0.0;  ///< from the south-west corner of the domain
    double heightM = 2.0;              ///< above sea level, where the rendered ground is
    double azimuthDeg = 0.0;           ///< of the view, clockwise from north
    double elevationDeg = 0.0;         ///< of the view above the horizon
    double fovDeg = 40.0;              ///< vertical
    bool operator==(const Observer&) const = default;
};

Observer observerOf(const CameraPose& pose, const RegularGrid& grid);

/// The target is the point of the line of sight that is nearest to the middle of the domain. Empty
/// if the eye is too far from the domain for a pose.
std::optional<CameraPose> poseOf(const Observer& observer, const RegularGrid& grid);

/// `pose` sees what `view` does; what it is fixed to stays.
void takeView(CameraPose& pose, const CameraPose& view);

/// Standard views: from above with north up, from the four sides, and from below. `fit` keeps the
/// direction.
enum class View : int { fit, plan, north, east, south, west, below };
inline constexpr std::array<std::string_view, 7> kViewNames{"fit",   "plan", "north", "east",
                                                            "south", "west", "below"};

/// `pose` turned to a standard view, with all of `boxes`, at least one, as large as possible in an
/// image of this aspect ratio, except for a margin. The distance is limited to that of a pose.
CameraPose viewOf(View view, CameraPose pose, const RegularGrid& grid, std::span<const BoxM> boxes,
                  double aspect);

/// Position of a point in the image, in [-1, 1] if inside; empty if it is behind the eye.
std::optional<glm::dvec2> ndcOf(const Camera& camera, const glm::dvec3& pointM);

}  // namespace neph
