// beam.cpp: marches from cell to cell, each after Simpson.
#include "core/transport/beam.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/transport/cell_walk.h"
#include "core/transport/grid_loops.h"

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

/// Rays against the beam's upstream plane: a square lattice on it, several to a cell.
struct BeamRays {
    static constexpr int kPerSide = 3;  ///< of a face of a cell

    glm::dvec3 perM{0.0};  ///< nodes a metre, with the light
    int across = 2, axisB = 0, axisC = 1;
    double plane = 0.0;  ///< node of `across`
    double startB = 0.0, startC = 0.0;
    int countB = 0, countC = 0;
    double power = 0.0;  ///< of each ray

    BeamRays(const TransportGrid& grid, const glm::dvec3& towardsSun);
    glm::dvec3 start(int b, int c) const {
        glm::dvec3 at(0.0);
        at[across] = plane;
        at[axisB] = startB + (b + 0.5) / kPerSide;
        at[axisC] = startC + (c + 0.5) / kPerSide;
        return at;
    }
};

BeamRays::BeamRays(const TransportGrid& grid, const glm::dvec3& towardsSun)
    : perM(-towardsSun / grid.spacingM) {
    // Between periodic sides all light comes from above.
    const glm::dvec3 rate = glm::abs(perM);
    if (!grid.periodicSides && std::max(rate.x, rate.y) > rate.z) across = rate.x > rate.y ? 0 : 1;
    axisB = across == 0 ? 1 : 0;
    axisC = across == 2 ? 1 : 2;
    plane = perM[across] > 0.0 ? 0.0 : grid.nodes[across] - 1;
    const double lengthM = (grid.nodes[across] - 1) / rate[across];
    const auto extent = [&](int axis, double& from, int& count) {
        const bool periodic = grid.periodic(axis);
        const double width = grid.nodes[axis] - (periodic ? 0 : 1);
        const double shift = periodic ? 0.0 : perM[axis] * lengthM;
        from = std::min(0.0, -std::ceil(shift));
        count = kPerSide * static_cast<int>(width + std::ceil(std::abs(shift)));
    };
    extent(axisB, startB, countB);
    extent(axisC, startC, countC);
    power = std::abs(towardsSun[across]) * grid.spacingM[axisB] * grid.spacingM[axisC] /
            (kPerSide * kPerSide);
}

/// What rays lose: around each node, altogether, and where nodes are far apart in optical depth.
struct DepositSum {
    std::vector<float> power;
    double whole = 0.0, underResolved = 0.0;
};

/// Leaves what a ray loses at the nodes around.
class Deposit {
  public:
    Deposit(const TransportLevel& level, float power, DepositSum& sum)
        : level_(level),
          power_(power),
          lengthM_(static_cast<float>(thicknessLengthM(level.grid.spacingM))),
          sum_(sum) {}

    bool operator()(const glm::ivec3& cell, const glm::vec3& entry, const glm::vec3& rate,
                    float lengthM) {
        constexpr float kNothing = 1e-5f, kUnderResolved = 4.0f;
        const CellCorners corners(level_.grid, level_.extinctionPerM, cell);
        const float most = corners.most(), entered = left_;
        if (most <= 0.0f) return true;
        // In a thick cell finer where the light enters: 1, 3, 5 ... parts of the length.
        const int pieces = most * lengthM > 1.0f ? 8 : 2;
        const auto endOf = [&](int piece) {
            const float t = static_cast<float>(piece) / static_cast<float>(pieces);
            return lengthM * (pieces > 2 ? t * t : t);
        };
        float before = corners.at(entry);
        for (int piece = 0; piece < pieces; ++piece) {
            const float from = endOf(piece), to = endOf(piece + 1);
            const float middle = corners.at(entry + rate * (0.5f * (from + to)));
            const float after = corners.at(entry + rate * to);
            const float depth = (to - from) / 6.0f * (before + 4.0f * middle + after);
            before = after;
            if (depth <= 0.0f) continue;
            const float lost = left_ * -std::expm1(-depth);
            const float centre = depth < 1.0f ? 0.5f : 0.5f / depth;
            give(corners, entry + rate * (from + centre * (to - from)), lost);
            left_ -= lost;
        }
        const double lost = static_cast<double>(power_) * static_cast<double>(entered - left_);
        sum_.whole += lost;
        if (most * lengthM_ > kUnderResolved) sum_.underResolved += lost;
        return left_ > kNothing;
    }

  private:
    void give(const CellCorners& corners, const glm::vec3& at, float lost) {
        const glm::vec3 share = depthShares(corners, lengthM_, glm::clamp(at, 0.0f, 1.0f));
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const float weight = ((corner & 1U) != 0 ? share.x : 1.0f - share.x) *
                                 ((corner & 2U) != 0 ? share.y : 1.0f - share.y) *
                                 ((corner & 4U) != 0 ? share.z : 1.0f - share.z);
            sum_.power[corners.node[corner]] += power_ * lost * weight;
        }
    }

    const TransportLevel& level_;
    float power_, lengthM_, left_ = 1.0f;
    DepositSum& sum_;
};

}  // namespace

double trilinear(const TransportGrid& grid, const std::vector<float>& values,
                 const glm::dvec3& atM) {
    return valueAtNode(grid, values, atM / grid.spacingM);
}

double depthTowards(const TransportLevel& level, const glm::dvec3& atM,
                    const glm::dvec3& towardsSun) {
    const TransportGrid& grid = level.grid;
    double depth = 0.0;
    walkCells(
        grid, atM / grid.spacingM, towardsSun / grid.spacingM,
        [&](const glm::ivec3& cell, const glm::vec3& entry, const glm::vec3& rate, float lengthM) {
            const CellCorners corners(grid, level.extinctionPerM, cell);
            if (corners.most() <= 0.0f) return true;
            const float sum = corners.at(entry) +
                              4.0f * corners.at(entry + rate * (0.5f * lengthM)) +
                              corners.at(entry + rate * lengthM);
            depth += static_cast<double>(lengthM / 6.0f * sum);
            return depth < kBlack;
        });
    return depth;
}

namespace {

/// Balanced nodes take what is deposited in them.
bool needsBeam(const TransportLevel& level, std::size_t node) {
    return level.place[node] >= 0 && !(level.thick() && level.balanced[node] >= 1.0f);
}

}  // namespace

std::vector<float> beamIrradiance(const TransportLevel& level, const glm::dvec3& towardsSun,
                                  int threads) {
    const TransportGrid& grid = level.grid;
    std::vector<float> irradiance(grid.nodeCount());
    const auto workers = static_cast<std::size_t>(std::max(threads, 1));
    shareOut(static_cast<std::size_t>(grid.nodes.z), workers,
             [&](std::size_t k, std::size_t, const Progress&) {
                 std::size_t node = k * grid.columnCount();
                 for (int j = 0; j < grid.nodes.y; ++j) {
                     for (int i = 0; i < grid.nodes.x; ++i, ++node) {
                         if (k > 0 && !needsBeam(level, node)) continue;
                         const glm::dvec3 atM =
                             glm::dvec3(i, j, static_cast<double>(k)) * grid.spacingM;
                         irradiance[node] =
                             static_cast<float>(std::exp(-depthTowards(level, atM, towardsSun)));
                     }
                 }
             });
    return irradiance;
}

double blendDeposit(const TransportLevel& level, const glm::dvec3& towardsSun, int threads,
                    std::vector<float>& irradiance) {
    const TransportGrid& grid = level.grid;
    const BeamRays rays(grid, towardsSun);
    const auto groups = static_cast<std::size_t>(std::max(threads, 1));
    std::vector<DepositSum> sums(groups);
    shareOut(groups, groups, [&](std::size_t group, std::size_t, const Progress&) {
        sums[group].power.assign(grid.nodeCount(), 0.0f);
        for (int c = static_cast<int>(group); c < rays.countC; c += static_cast<int>(groups)) {
            for (int b = 0; b < rays.countB; ++b) {
                walkCells(grid, rays.start(b, c), rays.perM,
                          Deposit(level, static_cast<float>(rays.power), sums[group]));
            }
        }
    });
    const double volumeM3 = grid.spacingM.x * grid.spacingM.y * grid.spacingM.z;
    forEachNode(grid, [&](const glm::ivec3& at, std::size_t node) {
        double power = 0.0;
        for (const DepositSum& sum : sums) power += static_cast<double>(sum.power[node]);
        const float share = level.balanced[node];
        if (share <= 0.0f) return;
        const auto toMean = static_cast<double>(timesCut(grid, at) / level.weightAt(node));
        const auto deposited = static_cast<float>(power * toMean / volumeM3);
        irradiance[node] += share * (deposited - irradiance[node]);
    });
    double whole = 0.0, underResolved = 0.0;
    for (const DepositSum& sum : sums) {
        whole += sum.whole;
        underResolved += sum.underResolved;
    }
    return whole > 0.0 ? underResolved / whole : 0.0;
}

}  // namespace neph
