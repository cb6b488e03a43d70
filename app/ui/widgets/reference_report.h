// reference_report.h: how far the reference has come with an image, in numbers and in words.
#pragma once
#include <limits>
#include <optional>
#include <string>

namespace neph::ui {

/// Of one image. The error is one standard deviation of its pixels as a share of their mean.
struct ReferenceReport {
    int paths = 0;  ///< a pixel
    double relativeError = std::numeric_limits<double>::infinity();
    double targetError = 0.0;
    double seconds = 0.0;  ///< of work so far
};

/// Whether it may rest. One path tells of no error.
bool isReached(const ReferenceReport& report);

/// Of work to come, from the paths there were: the error falls with the square root of their
/// number. None before it is known, or once the target is reached.
std::optional<double> secondsToTarget(const ReferenceReport& report);

/// "40 s", "2 min", "3 h", "12 days", of which nobody wants to know more.
std::string roughDuration(double seconds);

/// "37 paths per pixel, error 8.1 %, about 2 min to 2 %".
std::string pathsText(const ReferenceReport& report);

}  // namespace neph::ui
