// reference_text.cpp: standard errors to times and words.
#include "app/ui/widgets/reference_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"

namespace neph::ui {

std::optional<double> secondsToTarget(const ReferenceProgress& progress) {
    if (progress.samples < 2 || isReached(progress) || !(progress.targetError > 0.0)) return {};
    const double seconds = progress.seconds * (workTo(progress.targetError, progress) - 1.0);
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

std::string referenceText(const ReferenceProgress& progress) {
    std::string text =
        fmt::format("{} sample{} per pixel", progress.samples, progress.samples == 1 ? "" : "s");
    if (!std::isfinite(progress.relativeError)) return text;
    text += fmt::format(", error {} %", numberText(100.0 * progress.relativeError, 2));
    const std::optional<double> left = secondsToTarget(progress);
    if (!left) return text;
    return text + fmt::format(", about {} to {} %", roughDuration(*left),
                              numberText(100.0 * progress.targetError, 3));
}

}  // namespace neph::ui
