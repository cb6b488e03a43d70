// levels.cpp: computes interfaces from centres and centres from interfaces.
#include "readers/raw_les/levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace raw {
namespace {

constexpr double kSpacingTolerance = 1e-3;  // of a step; printed coordinates are accurate to 1e-6
constexpr double kMirrorTolerance = 0.05;   // of the local spacing

void requireIncreasing(std::span<const double> centresM) {
    for (std::size_t k = 1; k < centresM.size(); ++k) {
        if (centresM[k] > centresM[k - 1]) continue;
        throw Error{"level heights do not increase",
                    fmt::format("{} m after {} m at level {}", centresM[k], centresM[k - 1], k),
                    "heights from the ground up",
                    {}};
    }
}

bool isEven(std::span<const double> centresM) {
    const double step =
        (centresM.back() - centresM.front()) / static_cast<double>(centresM.size() - 1);
    for (std::size_t k = 1; k < centresM.size(); ++k) {
        if (std::abs(centresM[k] - centresM[k - 1] - step) > kSpacingTolerance * step) return false;
    }
    return true;
}

/// Rule 2 of the header; nothing if the interfaces deviate too far from the midpoints.
std::optional<std::vector<double>> mirrored(std::span<const double> centresM) {
    std::vector<double> interfaces{0.0};
    for (std::size_t k = 0; k < centresM.size(); ++k) {
        interfaces.push_back(2.0 * centresM[k] - interfaces.back());
        if (k + 1 == centresM.size()) break;
        const double spacing = centresM[k + 1] - centresM[k];
        const double halfWay = 0.5 * (centresM[k] + centresM[k + 1]);
        if (std::abs(interfaces.back() - halfWay) > kMirrorTolerance * spacing) return {};
    }
    if (interfaces.back() <= centresM.back()) return {};
    return interfaces;
}

}  // namespace

double evenSpacing(const std::string& axis, std::size_t count,
                   const std::function<double(std::size_t)>& at) {
    if (count < 2) return 0.0;
    const double step = (at(count - 1) - at(0)) / static_cast<double>(count - 1);
    for (std::size_t i = 1; i < count; ++i) {
        const double found = at(i) - at(i - 1);
        if (std::isfinite(found) && std::abs(found - step) <= kSpacingTolerance * std::abs(step) &&
            step != 0.0) {
            continue;
        }
        throw Error{fmt::format("the spacing of {} is not even", axis),
                    fmt::format("a step of {:.6g} before position {}, {:.6g} on average", found,
                                i + 1, step),
                    "the same step everywhere, to 0.1 %",
                    "horizontally stretched grids are not supported: interpolate to an even grid "
                    "first"};
    }
    return step;
}

std::vector<double> interfacesOf(std::span<const double> centresM) {
    if (centresM.size() < 2) {
        throw Error{"there is a single level",
                    fmt::format("{} level(s)", centresM.size()),
                    "at least two, which determine the depth of layers",
                    {}};
    }
    requireIncreasing(centresM);
    if (!isEven(centresM)) {
        if (auto interfaces = mirrored(centresM)) return *std::move(interfaces);
    }
    // Rules 1 and 3, which agree for even spacing.
    const std::size_t n = centresM.size();
    const double below = 1.5 * centresM[0] - 0.5 * centresM[1];
    std::vector<double> interfaces{centresM[0] > 0.0 ? std::max(below, 0.0) : below};
    for (std::size_t k = 1; k < n; ++k) {
        interfaces.push_back(0.5 * (centresM[k - 1] + centresM[k]));
    }
    interfaces.push_back(1.5 * centresM[n - 1] - 0.5 * centresM[n - 2]);
    return interfaces;
}

std::vector<double> centresOf(std::span<const double> interfacesM) {
    std::vector<double> centres;
    for (std::size_t k = 1; k < interfacesM.size(); ++k) {
        centres.push_back(0.5 * (interfacesM[k - 1] + interfacesM[k]));
    }
    return centres;
}

}  // namespace raw
