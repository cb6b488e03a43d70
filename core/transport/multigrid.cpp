// multigrid.cpp: W-cycles.
#include "core/transport/multigrid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/transport/balance.h"
#include "core/transport/sweep.h"

namespace neph {
namespace {

constexpr int kSweepsOnCoarsest = 4;  ///< times as many as on the levels above
/// Of a thick level's correction that is taken over: all of it overshoots.
constexpr float kThickPart = 0.7f;

/// Root mean square of l = 0, weighted by extinction.
double strength(const TransportLevel& level, const std::vector<float>& moments) {
    double sum = 0.0, weights = 0.0;
    for (std::size_t node = 0; node < level.place.size(); ++node) {
        const auto weight = static_cast<double>(level.weightAt(node));
        if (weight <= 0.0) continue;
        const auto value =
            static_cast<double>(moments[static_cast<std::size_t>(level.place[node]) *
                                        static_cast<std::size_t>(level.momentCount)]);
        sum += weight * value * value;
        weights += weight;
    }
    return weights > 0.0 ? std::sqrt(sum / weights) : 0.0;
}

class Correction {
  public:
    Correction(const std::vector<TransportLevel>& levels, const MultigridPass& pass)
        : levels_(levels), pass_(pass) {}

    /// Solves delta = K (delta + residual) on a level.
    LightField solved(std::size_t at, const LightField& residual) {
        const bool last = at + 1 == levels_.size();
        const int sweeps = pass_.sweepsPerLevel * (last ? kSweepsOnCoarsest : 1);
        LightField delta = levels_[at].emptyField();
        for (int i = 0; i < sweeps; ++i) {
            LightField scattered = delta;
            addTo(scattered, residual);
            LightField next = sweptOnce(at, scattered).field;
            if (!last) correct(at, delta, next);
            delta = std::move(next);
        }
        if (last && !coarsest_) coarsest_ = strength(levels_[at], delta.moments);
        return delta;
    }
    void correct(std::size_t at, const LightField& before, LightField& after) {
        const LightField residual = restricted(levels_[at], levels_[at + 1], after, before);
        addProlonged(levels_[at], levels_[at + 1], solved(at + 1, residual), 1.0f, after);
    }
    /// Solves error = K error + residual on a thick level.
    LightField solvedThick(std::size_t at, const LightField& residual) {
        const bool last = at + 1 == levels_.size();
        const int sweeps = pass_.sweepsPerLevel * (last ? kSweepsOnCoarsest : 1);
        LightField error = levels_[at].emptyField();
        const auto update = [&] {
            const Swept sums = sweptOnce(at, error);
            relax(missingAt(at, sums, error, residual), resistanceOf(levels_[at], sums), error);
        };
        for (int i = 0; i < sweeps; ++i) {
            update();
            if (last) continue;
            correctThick(at, missingAt(at, sweptOnce(at, error), error, residual), error);
        }
        if (!last) update();
        if (last && !coarsest_) coarsest_ = strength(levels_[at], error.moments);
        return error;
    }
    void correctThick(std::size_t at, const LightField& missing, LightField& field) {
        const LightField none = levels_[at].emptyField();
        const LightField residual = restricted(levels_[at], levels_[at + 1], missing, none);
        addProlonged(levels_[at], levels_[at + 1], solvedThick(at + 1, residual), kThickPart,
                     field);
    }
    double coarsest() const { return coarsest_.value_or(0.0); }

  private:
    Swept sweptOnce(std::size_t at, const LightField& scattered) const {
        SweepInput input;
        input.level = &levels_[at];
        input.field = &scattered;
        input.sunTravel = pass_.sunTravel;
        input.cubic = false;
        const auto perFlux = static_cast<float>(pass_.groundAlbedo / std::numbers::pi);
        for (const float flux : scattered.groundFlux) {
            input.groundRadiance.push_back(perFlux * flux);
        }
        return swept(input, *pass_.directions, pass_.threads);
    }
    LightField missingAt(std::size_t at, const Swept& sums, const LightField& error,
                         const LightField& residual) const {
        LightField missing = missingFrom(levels_[at], sums, error, nullptr);
        addTo(missing, residual);
        return missing;
    }

    const std::vector<TransportLevel>& levels_;
    const MultigridPass& pass_;
    std::optional<double> coarsest_;
};

}  // namespace

double correctByMultigrid(const std::vector<TransportLevel>& levels, const MultigridPass& pass,
                          const LightField& before, LightField& after) {
    const double whole = strength(levels[0], after.moments);
    if (levels.size() == 1) {
        std::vector<float> change = after.moments;
        for (std::size_t i = 0; i < change.size(); ++i) change[i] -= before.moments[i];
        return whole > 0.0 ? strength(levels[0], change) / whole : 0.0;
    }
    Correction correction(levels, pass);
    correction.correct(0, before, after);
    return whole > 0.0 ? correction.coarsest() / whole : 0.0;
}

double correctThick(const std::vector<TransportLevel>& levels, const MultigridPass& pass,
                    const LightField& missing, LightField& field) {
    const double whole = strength(levels[0], field.moments);
    Correction correction(levels, pass);
    correction.correctThick(0, missing, field);
    return whole > 0.0 ? correction.coarsest() / whole : 0.0;
}

}  // namespace neph
