// sun_chart.cpp: from directions to places of the chart and back.
#include "app/ui/camera/sun_chart.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace neph::ui {
namespace {

constexpr float kShareOfImage = 0.115f;             // radius, of the shorter side
constexpr float kLeastEms = 2.4f, kMostEms = 4.4f;  // radius; tuned by eye
constexpr float kRoseMarginEms = 1.0f,
                kLettersEms = 1.2f;     // to the image's edge, and around the rim
constexpr double kRoseTurnsDeg = 45.0;  // looking up more steeply, the rose is overhead

/// Distance from the middle in radii.
double shareOf(double elevationDeg) {
    return (90.0 - std::max(elevationDeg, kLowestOfChartDeg)) / 90.0;
}

}  // namespace

glm::vec2 SunChart::at(const SkyDirection& direction) const {
    const double turned = glm::radians(direction.azimuthDeg - aheadDeg);
    const double share = shareOf(direction.elevationDeg);
    const double down = fromBelow ? std::cos(turned) : -std::cos(turned);
    return middle + radius * glm::vec2(share * std::sin(turned), share * down);
}

SkyDirection SunChart::directionAt(glm::vec2 point) const {
    const glm::dvec2 off = glm::dvec2(point - middle) / static_cast<double>(radius);
    const double turned = std::atan2(off.x, fromBelow ? off.y : -off.y);
    return {aheadDeg + glm::degrees(turned), 90.0 * (1.0 - glm::length(off))};
}

SunChart sunChartOf(const Area& image, const CameraPose& pose) {
    const float em = ImGui::GetFontSize();
    SunChart chart;
    chart.radius = std::clamp(kShareOfImage * std::min(image.size().x, image.size().y),
                              kLeastEms * em, kMostEms * em);
    const double lowest = shareOf(kLowestOfChartDeg);
    const float reach =
        std::max(static_cast<float>(lowest) * chart.radius, chart.radius + kLettersEms * em);
    chart.middle = image.upper - glm::vec2(reach + kRoseMarginEms * em);
    chart.aheadDeg = static_cast<double>(pose.azimuthDeg) + 180.0;
    chart.fromBelow = static_cast<double>(pose.elevationDeg) < -kRoseTurnsDeg;
    return chart;
}

bool joined(const SunPathPoint& from, const SunPathPoint& to) {
    constexpr double kMostDeg = 30.0;
    const bool up = std::max(from.elevationDeg, to.elevationDeg) > kLowestOfChartDeg;
    return up || std::abs(std::remainder(to.azimuthDeg - from.azimuthDeg, 360.0)) < kMostDeg;
}

std::optional<NearestOfPath> nearestOfPath(const SunChart& chart,
                                           std::span<const SunPathPoint> path, glm::vec2 point) {
    std::optional<NearestOfPath> best;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const SunPathPoint &from = path[i - 1], &to = path[i];
        if (!joined(from, to)) continue;
        const glm::vec2 a = chart.at({from.azimuthDeg, from.elevationDeg});
        const glm::vec2 along = chart.at({to.azimuthDeg, to.elevationDeg}) - a;
        const float length = glm::dot(along, along);
        const float share =
            length > 0.0f ? std::clamp(glm::dot(point - a, along) / length, 0.0f, 1.0f) : 0.0f;
        const float distance = glm::length(a + share * along - point);
        if (best && distance >= best->distance) continue;
        const auto mix = [share](double x, double y) {
            return std::lerp(x, y, static_cast<double>(share));
        };
        // Through north the azimuth goes from 360 to 0.
        const double step = std::remainder(to.azimuthDeg - from.azimuthDeg, 360.0);
        best = {mix(from.hour, to.hour),
                {from.azimuthDeg + static_cast<double>(share) * step,
                 mix(from.elevationDeg, to.elevationDeg)},
                distance};
    }
    return best;
}

}  // namespace neph::ui
