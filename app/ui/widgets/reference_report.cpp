// reference_report.cpp: standard errors to times and words.
#include "app/ui/widgets/reference_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"

namespace neph::ui {

bool isReached(const ReferenceReport& report) {
    return report.paths >= 2 && report.relativeError <= report.targetError;
}

std::optional<double> secondsToTarget(const ReferenceReport& report) {
    if (report.paths < 2 || isReached(report) || !(report.targetError > 0.0)) return {};
    const double ratio = report.relativeError / report.targetError;
    const double seconds = report.seconds * (ratio * ratio - 1.0);
    return std::isfinite(seconds) ? std::optional(seconds) : std::nullopt;
}

std::string roughDuration(double seconds) {
    constexpr std::array<std::pair<double, const char*>, 3> kUnits{
        {{60.0, "s"}, {60.0, "min"}, {24.0, "h"}}};
    double left = seconds;
    for (const auto& [most, unit] : kUnits) {
        if (std::lround(left) < std::lround(most)) return fmt::format("{:.0f} {}", left, unit);
        left /= most;
    }
    const bool one = std::lround(left) == 1;
    return fmt::format("{} day{}", numberText(std::round(left), 2), one ? "" : "s");
}

std::string pathsText(const ReferenceReport& report) {
    std::string text = fmt::format("{} sample{} per pixel", report.paths, report.paths == 1 ? "" : "s");
    if (!std::isfinite(report.relativeError)) return text;
    text += fmt::format(", error {} %", numberText(100.0 * report.relativeError, 2));
    const std::optional<double> left = secondsToTarget(report);
    if (!left) return text;
    return text + fmt::format(", about {} to {} %", roughDuration(*left),
                              numberText(100.0 * report.targetError, 3));
}

}  // namespace neph::ui
