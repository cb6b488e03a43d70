// beam.cpp: marches from slice to slice towards the sun, each segment after Simpson.
#include "core/transport/beam.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace neph {
namespace {

constexpr double kBlack = 40.0;  ///< optical depth behind which nothing is left

struct AxisPoint {
    int low = 0, high = 0;
    double share = 0.0;  ///< of `high`
    bool outside = false;
};

AxisPoint axisPoint(const TransportGrid& grid, int axis, double at) {
    constexpr double kRounding = 1e-6;
    const int n = grid.nodes[axis];
    if (grid.periodic(axis)) {
        const double wrapped = at - n * std::floor(at / n);
        const int low = static_cast<int>(wrapped) % n;
        return {low, (low + 1) % n, wrapped - std::floor(wrapped), false};
    }
    if (at < -kRounding || at > n - 1 + kRounding) return {0, 0, 0.0, true};
    const int low = std::clamp(static_cast<int>(at), 0, n - 2);
    return {low, low + 1, std::clamp(at - low, 0.0, 1.0), false};
}

/// `at` is in nodes.
double valueAtNode(const TransportGrid& grid, const std::vector<float>& values,
                   const glm::dvec3& at) {
    const AxisPoint x = axisPoint(grid, 0, at.x), y = axisPoint(grid, 1, at.y),
                    z = axisPoint(grid, 2, at.z);
    if (x.outside || y.outside || z.outside) return 0.0;
    const auto line = [&](int j, int k) {
        return glm::mix(static_cast<double>(values[grid.index(x.low, j, k)]),
                        static_cast<double>(values[grid.index(x.high, j, k)]), x.share);
    };
    return glm::mix(glm::mix(line(y.low, z.low), line(y.high, z.low), y.share),
                    glm::mix(line(y.low, z.high), line(y.high, z.high), y.share), z.share);
}

/// Metres from `at`, in nodes, to where a ray leaves the medium.
double lengthInside(const TransportGrid& grid, const glm::dvec3& at, const glm::dvec3& perM) {
    double length = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (grid.periodic(axis) || perM[axis] == 0.0) continue;
        const double end = perM[axis] > 0.0 ? grid.nodes[axis] - 1 : 0.0;
        length = std::min(length, (end - at[axis]) / perM[axis]);
    }
    return std::max(length, 0.0);
}

}  // namespace

double trilinear(const TransportGrid& grid, const std::vector<float>& values,
                 const glm::dvec3& atM) {
    return valueAtNode(grid, values, atM / grid.spacingM);
}

double depthTowards(const TransportLevel& level, const glm::dvec3& atM,
                    const glm::dvec3& towardsSun) {
    const TransportGrid& grid = level.grid;
    const glm::dvec3 start = atM / grid.spacingM, perM = towardsSun / grid.spacingM;
    const double total = lengthInside(grid, start, perM);
    const glm::dvec3 rate = glm::abs(perM);
    const double stepM = 1.0 / std::max(rate.x, std::max(rate.y, rate.z));
    const auto at = [&](double m) {
        return valueAtNode(grid, level.extinctionPerM, start + perM * m);
    };
    double depth = 0.0, before = at(0.0);
    for (double from = 0.0; from < total && depth < kBlack; from += stepM) {
        const double to = std::min(from + stepM, total), now = at(to);
        depth += (to - from) / 6.0 * (before + 4.0 * at((from + to) / 2.0) + now);
        before = now;
    }
    return depth;
}

std::vector<float> beamIrradiance(const TransportLevel& level, const glm::dvec3& towardsSun,
                                  int threads) {
    if (towardsSun.z <= 0.0) return {};
    const TransportGrid& grid = level.grid;
    std::vector<float> irradiance(grid.nodeCount());
    const auto workers = static_cast<std::size_t>(std::max(threads, 1));
    shareOut(static_cast<std::size_t>(grid.nodes.z), workers,
             [&](std::size_t k, std::size_t, const Progress&) {
                 std::size_t node = k * grid.columnCount();
                 for (int j = 0; j < grid.nodes.y; ++j) {
                     for (int i = 0; i < grid.nodes.x; ++i) {
                         const glm::dvec3 atM =
                             glm::dvec3(i, j, static_cast<double>(k)) * grid.spacingM;
                         irradiance[node++] =
                             static_cast<float>(std::exp(-depthTowards(level, atM, towardsSun)));
                     }
                 }
             });
    return irradiance;
}

}  // namespace neph
