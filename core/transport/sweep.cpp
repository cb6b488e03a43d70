// sweep.cpp: the directions of a set in batches: what is scattered into each of them, its way
// through the medium, and what it adds to the moments.
#include "core/transport/sweep.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <span>
#include <utility>

#include "core/base/parallel.h"
#include "core/transport/direction_sweep.h"
#include "core/transport/flush_tiny.h"
#include "core/transport/moment_lanes.h"

namespace neph {
namespace {

constexpr std::size_t kBatch = 16;           // directions
constexpr std::size_t kBlock = 32;           // groups of nodes, whose moments stay close at hand
constexpr std::size_t kWorthAThread = 4096;  // nodes

void add(const std::vector<float>& term, std::vector<float>& sum) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += term[i];
}

/// The sweep along a set of directions of a field of kCount moments.
template <std::size_t kCount>
class SetSweep {
  public:
    SetSweep(const SweepInput& input, int threads)
        : input_(input),
          level_(*input.level),
          groups_(MomentLanes::groupsOf(level_.activeCount)),
          workers_(level_.grid.nodeCount() < kWorthAThread
                       ? 1
                       : static_cast<std::size_t>(std::max(threads, 1))),
          source_(level_.activeCount, kCount),
          sum_(level_.activeCount, kCount),
          ends_(workers_) {
        for (SweptEnds& ends : ends_) {
            ends.groundFlux.assign(level_.grid.columnCount(), 0.0f);
            if (!level_.thick()) continue;
            ends.excess.assign(level_.activeCount, 0.0f);
            ends.exchange.assign(level_.activeCount, 0.0f);
        }
    }

    Swept along(const LightDirections& directions) {
        setSource();
        const std::size_t batch = std::min(kBatch, directions.size());
        const std::vector<float> empty(groups_ * MomentLanes::kLanes);
        along_.assign(batch, empty);
        if (level_.thick()) even_.assign(batch, empty);
        for (std::size_t first = 0; first < directions.size(); first += batch) {
            const std::span of(&directions[first], std::min(batch, directions.size() - first));
            scatterInto(of);
            shareOut(workers_, workers_, [&](std::size_t worker, std::size_t, const Progress&) {
                const FlushTiny flush;
                for (std::size_t i = worker; i < of.size(); i += workers_) sweep(of[i], i, worker);
            });
            collect(of);
        }
        return result();
    }

  private:
    using Set = std::span<const LightDirection>;
    using Values = std::vector<std::vector<float>>;  // of each direction of a batch

    /// `work(first, count)` of all groups of nodes.
    template <typename Work>
    void inBlocks(const Work& work) const {
        shareOut((groups_ + kBlock - 1) / kBlock, workers_,
                 [&](std::size_t block, std::size_t, const Progress&) {
                     const std::size_t first = block * kBlock;
                     work(first, std::min(kBlock, groups_ - first));
                 });
    }
    /// Moments of the source function: what is scattered of the field, and of the beam.
    void setSource() {
        const Harmonics ofBeam = harmonicsAt(input_.sunTravel, input_.sunTravel);
        const auto degrees = static_cast<std::size_t>(level_.degreeCount);
        for (std::size_t node = 0; node < level_.place.size(); ++node) {
            if (level_.place[node] < 0) continue;
            const auto place = static_cast<std::size_t>(level_.place[node]);
            const float beam = input_.beam != nullptr ? input_.beam[node] : 0.0f;
            const float* moments = &input_.field->moments[place * kCount];
            const float* albedo = &level_.albedo[place * degrees];
            float* source = source_.at(place);
            for (std::size_t q = 0; q < kCount; ++q) {
                const float scattered = albedo[degreeOf(static_cast<int>(q))];
                source[q * MomentLanes::kLanes] = scattered * (moments[q] + beam * ofBeam[q]);
            }
        }
    }
    void scatterInto(const Set& set) {
        inBlocks([&](std::size_t first, std::size_t count) {
            const std::size_t node = first * MomentLanes::kLanes;
            for (std::size_t i = 0; i < set.size(); ++i) {
                Harmonics weights = harmonicsAt(set[i].travel, input_.sunTravel);
                sumMoments<kCount>(source_.group(first), count, weights.data(), &along_[i][node]);
                if (!level_.thick()) continue;
                for (std::size_t q = 0; q < kCount; ++q) {
                    if (degreeOf(static_cast<int>(q)) % 2 != 0) weights[q] = 0.0f;
                }
                sumMoments<kCount>(source_.group(first), count, weights.data(), &even_[i][node]);
            }
        });
    }
    void sweep(const LightDirection& direction, std::size_t i, std::size_t worker) {
        float* along = along_[i].data();
        if (level_.thick()) {
            DirectionSweep<true>(input_, direction, {along, even_[i].data()}, ends_[worker]).run();
        } else {
            DirectionSweep<false>(input_, direction, {along, nullptr}, ends_[worker]).run();
        }
    }
    void collect(const Set& set) {
        inBlocks([&](std::size_t first, std::size_t count) {
            const std::size_t node = first * MomentLanes::kLanes;
            for (std::size_t i = 0; i < set.size(); ++i) {
                Harmonics weights = harmonicsAt(set[i].travel, input_.sunTravel);
                for (float& weight : weights) weight *= static_cast<float>(set[i].weightSr);
                addMoments<kCount>(&along_[i][node], count, weights.data(), sum_.group(first));
            }
        });
    }
    Swept result() {
        Swept swept;
        swept.field.moments.resize(level_.activeCount * kCount);
        for (std::size_t node = 0; node < level_.activeCount; ++node) {
            const float* from = sum_.at(node);
            float* to = &swept.field.moments[node * kCount];
            for (std::size_t q = 0; q < kCount; ++q) to[q] = from[q * MomentLanes::kLanes];
        }
        for (std::size_t worker = 1; worker < workers_; ++worker) {
            add(ends_[worker].groundFlux, ends_[0].groundFlux);
            add(ends_[worker].excess, ends_[0].excess);
            add(ends_[worker].exchange, ends_[0].exchange);
        }
        swept.field.groundFlux = std::move(ends_[0].groundFlux);
        swept.excess = std::move(ends_[0].excess);
        swept.exchange = std::move(ends_[0].exchange);
        return swept;
    }

    const SweepInput& input_;
    const TransportLevel& level_;
    std::size_t groups_, workers_;
    MomentLanes source_, sum_;
    Values along_, even_;
    std::vector<SweptEnds> ends_;  // of each worker
};

/// A random set has not quite the right flux through a horizontal plane.
void scaleGroundFlux(const SkyLight& sky, const LightDirections& directions, LightField& field) {
    const bool dark = sky.isDark();
    double downward = 0.0;
    for (const LightDirection& d : directions) {
        const double up = -d.travel.z;
        if (up > 0.0) downward += d.weightSr * up * (dark ? 1.0 : sky.radianceAt(-d.travel));
    }
    const auto scale = static_cast<float>((dark ? std::numbers::pi : sky.irradiance()) / downward);
    for (float& flux : field.groundFlux) flux *= scale;
}

}  // namespace

Swept swept(const SweepInput& input, const LightDirections& directions, int threads) {
    Swept sums = input.level->momentCount == kBroadMoments
                     ? SetSweep<kBroadMoments>(input, threads).along(directions)
                     : SetSweep<kAlignedMoments>(input, threads).along(directions);
    scaleGroundFlux(input.sky, directions, sums.field);
    return sums;
}

std::size_t sweptBytes(const TransportLevel& level) {
    constexpr std::size_t kFields = 3;  // source, sum, result
    const std::size_t batches = level.thick() ? 2 : 1;
    return sizeof(float) * level.activeCount *
           (kFields * static_cast<std::size_t>(level.momentCount) + batches * kBatch);
}

}  // namespace neph
