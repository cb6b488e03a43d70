// light_around.cpp: a sweep of a coarse grid that collects at all of its nodes.
#include "core/transport/light_around.h"

#include <algorithm>
#include <array>

#include "core/transport/beam.h"
#include "core/transport/light_solver.h"

namespace neph {
namespace {

constexpr int kSets = 6;  // of 12 directions

/// The same level with moments everywhere.
TransportLevel collectingEverywhere(TransportLevel level) {
    const TransportLevel some = level;
    const auto degrees = static_cast<std::size_t>(level.degreeCount);
    level.numberAll();
    if (level.thick()) level.aroundPerM.assign(level.activeCount, 0.0f);
    for (std::size_t node = 0; node < some.place.size(); ++node) {
        if (some.place[node] < 0) continue;
        std::copy_n(some.albedoAt(node), degrees, level.albedoAt(node));
        if (!level.thick()) continue;
        level.aroundPerM[static_cast<std::size_t>(level.place[node])] =
            some.aroundPerM[static_cast<std::size_t>(some.place[node])];
    }
    return level;
}

/// The moments of some nodes among those of all.
LightField spreadOut(const TransportLevel& some, const LightField& field,
                     const TransportLevel& all) {
    LightField whole = all.emptyField();
    const auto moments = static_cast<std::size_t>(some.momentCount);
    for (std::size_t node = 0; node < some.place.size(); ++node) {
        if (some.place[node] < 0) continue;
        std::copy_n(&field.moments[static_cast<std::size_t>(some.place[node]) * moments], moments,
                    &whole.moments[static_cast<std::size_t>(all.place[node]) * moments]);
    }
    whole.groundFlux = field.groundFlux;
    return whole;
}

LightDirections manyDirections(std::uint64_t seed) {
    DirectionSource source(seed);
    LightDirections all;
    for (int set = 0; set < kSets; ++set) {
        for (LightDirection direction : source.turnedIcosahedron()) {
            direction.weightSr /= kSets;
            all.push_back(direction);
        }
    }
    return all;
}

}  // namespace

LightAround lightAround(const LightSolver& solver, std::size_t mostNodes) {
    const auto& levels = solver.levels();
    LightField field = solver.field();
    std::size_t at = 0;
    while (at + 1 < levels.size() && levels[at].grid.nodeCount() > mostNodes) {
        field = restricted(levels[at], levels[at + 1], field, levels[at].emptyField());
        ++at;
    }
    const TransportLevel all = collectingEverywhere(levels[at]);
    const LightField whole = spreadOut(levels[at], field, all);
    const LightDirections directions = manyDirections(solver.settings().seed);
    const LevelBeam beam = solver.beamOn(all);
    const SweepInput input = solver.sweepInput(all, whole, beam);
    const Swept sums = swept(input, directions, solver.settings().threads);
    std::array<double, kBroadMoments> clear{};
    for (const LightDirection& d : directions) {
        const double enters = d.travel.z < 0.0 ? input.sky.radianceAt(-d.travel)
                                               : static_cast<double>(input.farGroundRadiance);
        const Harmonics y = harmonicsAt(d.travel, input.sunTravel);
        for (std::size_t q = 0; q < clear.size(); ++q) {
            clear[q] += d.weightSr * enters * static_cast<double>(y[q]);
        }
    }
    LightAround around{all.grid, {}};
    const auto count = static_cast<std::size_t>(all.momentCount);
    for (std::size_t node = 0; node < all.activeCount; ++node) {
        for (std::size_t q = 0; q < clear.size(); ++q) {
            around.change.push_back(sums.field.moments[node * count + q] -
                                    static_cast<float>(clear[q]));
        }
    }
    return around;
}

}  // namespace neph
