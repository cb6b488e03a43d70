// grid_text.cpp: rounds, then chooses the unit.
#include "core/dataset/grid_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace neph {
namespace {

constexpr double kMPerKm = 1000.0;
constexpr double kSecondsPerMinute = 60.0;
constexpr double kSameStep = 1e-4;  // of a step: files round their times

/// Three significant digits, so that 999.9 m becomes 1 km and not 1e+03 m.
double rounded(double value) {
    if (!(value > 0.0)) return value;
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
    return std::round(value / unit) * unit;
}

/// Two texts that end in units, as a range; the first needs no unit where it is the same.
std::string rangeText(const std::string& from, const std::string& to) {
    if (from == to) return to;
    const std::size_t space = from.find(' ');
    const bool same = from.substr(space) == to.substr(to.find(' '));
    return fmt::format("{} to {}", same ? from.substr(0, space) : from, to);
}

std::string widthAlong(const DatasetInfo& info, int axis) {
    if (info.edgesM[static_cast<std::size_t>(axis)].empty()) {
        return lengthText(info.spacingM[axis]);
    }
    double least = std::numeric_limits<double>::max(), most = 0.0;
    for (int cell = 0; cell < info.size[axis]; ++cell) {
        const double width = info.edgeM(axis, cell + 1) - info.edgeM(axis, cell);
        least = std::min(least, width);
        most = std::max(most, width);
    }
    return rangeText(lengthText(least), lengthText(most));
}

}  // namespace

std::string lengthText(double metres) {
    const double shown = rounded(metres);
    // A sum of rounded faces may miss a kilometre by its last bit.
    if (shown < kMPerKm * (1.0 - 1e-9)) return fmt::format("{:.3g} m", shown);
    return shown < kMPerKm * kMPerKm ? fmt::format("{:.3g} km", shown / kMPerKm)
                                     : fmt::format("{:.0f} km", shown / kMPerKm);
}

std::string cellWidthText(const DatasetInfo& info, std::string_view times) {
    const std::string x = widthAlong(info, 0), y = widthAlong(info, 1);
    return x == y ? x : fmt::format("{}{}{}", x, times, y);
}

std::string minutesText(double seconds) {
    if (seconds < kSecondsPerMinute) return fmt::format("{:.4g} s", seconds);
    return fmt::format("{:.6g} min", seconds / kSecondsPerMinute);
}

std::string timeStepText(const DatasetInfo& info) {
    if (info.times.size() < 2) return {};
    double least = std::numeric_limits<double>::max(), most = 0.0;
    for (std::size_t i = 1; i < info.times.size(); ++i) {
        const double step = info.times[i].seconds - info.times[i - 1].seconds;
        least = std::min(least, step);
        most = std::max(most, step);
    }
    if (most - least <= kSameStep * most) {
        const double span = info.times.back().seconds - info.times.front().seconds;
        return "every " + minutesText(span / static_cast<double>(info.times.size() - 1));
    }
    return rangeText(minutesText(least), minutesText(most)) + " apart";
}

}  // namespace neph
