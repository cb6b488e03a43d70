// levels.cpp: computes interfaces from centres and centres from interfaces.
#include "readers/les/levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace les {
namespace {

constexpr double kSpacingTolerance = 1e-3;  // of a step; printed coordinates are accurate to 1e-6
constexpr double kMirrorTolerance = 0.05;   // of the local spacing

void requireIncreasing(const std::string& what, std::span<const double> centresM) {
    for (std::size_t k = 1; k < centresM.size(); ++k) {
        if (centresM[k] > centresM[k - 1]) continue;
        throw Error{what + " do not increase",
                    fmt::format("{} m after {} m at number {}", centresM[k], centresM[k - 1], k),
                    "each above the one before",
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

/// The middle of the half of the values that lie closest together.
double agreed(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = (values.size() + 1) / 2;
    std::size_t best = 0;
    for (std::size_t i = 0; i + half <= values.size(); ++i) {
        const auto range = [&](std::size_t from) { return values[from + half - 1] - values[from]; };
        if (range(i) < range(best)) best = i;
    }
    return values[best + half / 2];
}

/// Faces with every centre in the middle of its cell; none if there are fewer than four cells or
/// the faces are not smooth. See the header.
std::vector<double> smoothFaces(std::span<const double> centresM) {
    constexpr double kTolerance =
        0.2;  // of the local spacing: neighbours differ by a factor of 2.3
    const std::size_t n = centresM.size();
    if (n < 4) return {};
    std::vector<double> faces{centresM[0]};
    for (const double centre : centresM) faces.push_back(2.0 * centre - faces.back());
    std::vector<double> shifts;
    for (std::size_t i = 2; i + 1 < n; ++i) {
        const double smooth =
            (5.0 * (centresM[i - 1] + centresM[i]) - centresM[i - 2] - centresM[i + 1]) / 8.0;
        shifts.push_back((i % 2 == 0 ? 1.0 : -1.0) * (smooth - faces[i]));
    }
    const double shift = agreed(shifts);
    for (std::size_t i = 0; i <= n; ++i) faces[i] += i % 2 == 0 ? shift : -shift;
    for (std::size_t i = 1; i <= n; ++i) {
        if (!(faces[i] > faces[i - 1])) return {};
        if (i == n) break;
        const double spacing = centresM[i] - centresM[i - 1];
        const double halfWay = 0.5 * (centresM[i] + centresM[i - 1]);
        if (std::abs(faces[i] - halfWay) > kTolerance * spacing) return {};
    }
    return faces;
}

}  // namespace

std::optional<double> evenStep(std::span<const double> centresM) {
    constexpr double kTolerance = 0.01;  // of a step; printed coordinates have six digits
    const std::size_t n = centresM.size();
    if (n < 2) return 0.0;
    const double step = (centresM.back() - centresM.front()) / static_cast<double>(n - 1);
    if (!std::isfinite(step) || step == 0.0) return {};
    for (std::size_t i = 1; i < n; ++i) {
        const double place = centresM.front() + step * static_cast<double>(i);
        if (!(std::abs(centresM[i] - place) <= kTolerance * std::abs(step))) return {};
    }
    return step;
}

std::vector<double> facesOf(const std::string& axis, std::span<const double> centresM) {
    requireIncreasing("positions of " + axis, centresM);
    std::vector<double> faces = smoothFaces(centresM);
    if (faces.empty()) {
        const std::size_t n = centresM.size();
        faces.push_back(1.5 * centresM[0] - 0.5 * centresM[1]);
        for (std::size_t i = 1; i < n; ++i) faces.push_back(0.5 * (centresM[i - 1] + centresM[i]));
        faces.push_back(1.5 * centresM[n - 1] - 0.5 * centresM[n - 2]);
    }
    startAtZero("faces of " + axis, faces);
    return faces;
}

void startAtZero(const std::string& what, std::vector<double>& faces) {
    const double first = faces.front();
    for (double& face : faces) face -= first;
    requireIncreasing(what, faces);
    if (!std::isfinite(faces.back())) throw Error{what + " are too far apart", {}, "metres", {}};
}

std::vector<double> interfacesOf(std::span<const double> centresM) {
    if (centresM.size() < 2) {
        throw Error{"there is a single level",
                    fmt::format("{} level(s)", centresM.size()),
                    "at least two, which determine the depth of layers",
                    {}};
    }
    requireIncreasing("level heights", centresM);
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

}  // namespace les
