// reference_text.cpp: standard errors to times and words.
#include "app/ui/widgets/reference_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/look/engines.h"

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
    std::string text = countText(progress.samples, "sample") + " per pixel";
    if (!std::isfinite(progress.relativeError)) return text;
    text += fmt::format(", error {} %", numberText(100.0 * progress.relativeError, 2));
    const std::optional<double> left = secondsToTarget(progress);
    if (!left) return text;
    return text + fmt::format(", about {} to {} %", roughDuration(*left),
                              numberText(100.0 * progress.targetError, 3));
}

std::string previewText(int samples) {
    return fmt::format("{} of {} per pixel", kPreviewName, countText(samples, "sample"));
}

std::string previewMeaning() {
    return "Most of the noise is averaged away, and with it faint detail and the light of single "
           "bright pixels.\nFor looking at: files, figures and error images have the image as it "
           "was traced.";
}

}  // namespace neph::ui
