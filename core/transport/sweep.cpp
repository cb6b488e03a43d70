// sweep.cpp: the directions of a set, shared out over threads.
#include "core/transport/sweep.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "core/base/parallel.h"
#include "core/transport/direction_sweep.h"
#include "core/transport/flush_tiny.h"

namespace neph {
namespace {

/// A random set has not quite the right flux through a horizontal plane.
void scaleGroundFlux(const SkyLight& sky, const LightDirections& directions, LightField& field) {
    const bool dark = sky == SkyLight{0.0, 0.0};
    double downward = 0.0;
    for (const LightDirection& d : directions) {
        const double up = -d.travel.z;
        if (up > 0.0) downward += d.weightSr * up * (dark ? 1.0 : sky.radianceAt(up));
    }
    const auto scale = static_cast<float>((dark ? std::numbers::pi : sky.irradiance()) / downward);
    for (float& flux : field.groundFlux) flux *= scale;
}

Swept emptySum(const TransportLevel& level) {
    Swept sum;
    sum.field = level.emptyField();
    if (level.thick()) {
        sum.excess.assign(level.activeCount, 0.0f);
        sum.exchange.assign(level.activeCount, 0.0f);
    }
    return sum;
}

template <int kMoments>
void sweepAlong(const SweepInput& input, const LightDirection& direction, Swept& sum) {
    if (input.level->thick()) {
        DirectionSweep<kMoments, true>(input, direction, sum).run();
    } else {
        DirectionSweep<kMoments, false>(input, direction, sum).run();
    }
}

}  // namespace

Swept swept(const SweepInput& input, const LightDirections& directions, int threads) {
    constexpr std::size_t kWorthAThread = 4096;
    const TransportLevel& level = *input.level;
    const std::size_t groups =
        level.grid.nodeCount() < kWorthAThread ? 1 : static_cast<std::size_t>(std::max(threads, 1));
    std::vector<Swept> sums(groups);
    shareOut(groups, groups, [&](std::size_t group, std::size_t, const Progress&) {
        const FlushTiny flush;
        sums[group] = emptySum(level);
        for (std::size_t i = group; i < directions.size(); i += groups) {
            if (level.momentCount == kBroadMoments) {
                sweepAlong<kBroadMoments>(input, directions[i], sums[group]);
            } else {
                sweepAlong<kAlignedMoments>(input, directions[i], sums[group]);
            }
        }
    });
    for (std::size_t group = 1; group < groups; ++group) {
        addTo(sums[0].field, sums[group].field);
        for (std::size_t i = 0; i < sums[0].excess.size(); ++i) {
            sums[0].excess[i] += sums[group].excess[i];
            sums[0].exchange[i] += sums[group].exchange[i];
        }
    }
    scaleGroundFlux(input.sky, directions, sums[0].field);
    return std::move(sums[0]);
}

}  // namespace neph
