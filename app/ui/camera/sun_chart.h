// sun_chart.h: the sky over the compass rose: the zenith in the middle, the horizon at the rim, and
// the sun's path of the day on it.
//
// Straight ahead is up. Pixels of ImGui; azimuths in the frame of the grid, degrees.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "app/ui/panel/layout.h"
#include "core/camera/camera.h"
#include "core/look/sun.h"

namespace neph::ui {

/// Deeper than this below the horizon there is no twilight; the chart ends there.
inline constexpr double kLowestOfChartDeg = -18.0;

struct SkyDirection {
    double azimuthDeg = 0.0, elevationDeg = 0.0;
};

struct SunChart {
    glm::vec2 middle{0.0f};
    float radius = 0.0f;     ///< of the horizon
    double aheadDeg = 0.0;   ///< azimuth that is up
    bool fromBelow = false;  ///< the eye looks up at the rose: ahead is down

    /// Lower than the lowest: there.
    glm::vec2 at(const SkyDirection& direction) const;
    SkyDirection directionAt(glm::vec2 point) const;
};

/// In the lower right corner of the image.
SunChart sunChartOf(const Area& image, const CameraPose& pose);

/// Whether the chart has a line from one point of a path to the next; no line crosses it where the
/// sun passes far below.
bool joined(const SunPathPoint& from, const SunPathPoint& to);

/// The place on a path that is nearest to a point of the chart.
struct NearestOfPath {
    double hour = 0.0;  ///< UTC, 0 to 24
    SkyDirection direction;
    float distance = 0.0f;  ///< pixels
};
/// None of an empty path.
std::optional<NearestOfPath> nearestOfPath(const SunChart& chart,
                                           std::span<const SunPathPoint> path, glm::vec2 point);

}  // namespace neph::ui
