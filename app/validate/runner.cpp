// runner.cpp: a first round of paths shows how many each detector needs; up to three more rounds
// supply them.
//
// Because the number of paths depends on the first measurements, a mean is biased, but by less than
// its standard error divided by the square root of that number.
#include "app/validate/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <span>

#include "core/base/hash.h"

namespace neph::validate {
namespace {

using render::Measured;
using SampleCounts = std::vector<std::uint64_t>;  // paths, for each detector

constexpr std::size_t kMaxDetectorsPerCall = 1024;
constexpr int kMoreRounds = 3;
constexpr double kMaxGrowthPerRound = 32.0;  // the first estimate of a standard error is rough

/// Both measurements combined, weighted by their numbers of paths.
Measured pooled(const Measured& a, const Measured& b) {
    const auto n = static_cast<double>(a.samples), m = static_cast<double>(b.samples);
    if (n + m <= 0.0) return a;
    return {(n * a.mean + m * b.mean) / (n + m), std::hypot(n * a.sigma, m * b.sigma) / (n + m),
            a.samples + b.samples};
}

/// Measured value of a quantity.
struct Value {
    double mean = 0.0, sigma = 0.0;
    std::uint64_t samples = 0;
};

/// Weighted sum of the readings. Detectors use separate paths, so their errors are independent.
Value valueOf(const Quantity& quantity, const std::vector<Measured>& readings) {
    Value value{quantity.offset, 0.0, 0};
    for (const Term& term : quantity.terms) {
        const Measured& reading = readings[term.detector];
        value.mean += term.factor * reading.mean;
        value.sigma = std::hypot(value.sigma, term.factor * reading.sigma);
        value.samples += reading.samples;
    }
    return value;
}

/// Readings of all detectors of a trial in one scene.
class Measurement {
  public:
    Measurement(render::TraceMeter& meter, const Trial& trial, const render::MeterScene& scene,
                const render::MeterSettings& settings, const Progress& progress)
        : meter_(meter),
          trial_(trial),
          scene_(scene),
          settings_(settings),
          progress_(progress),
          readings_(trial.detectors.size()) {
        settings_.seed ^= static_cast<std::uint32_t>(hashOf(trial.name));
    }

    /// Measures until the standard error of each quantity is `share` of its tolerance, within the
    /// limits of `effort`.
    void run(const Effort& effort, double share) {
        add(SampleCounts(readings_.size(), effort.first));
        for (int round = 0; round < kMoreRounds; ++round) {
            const SampleCounts more = missingSamples(effort, share);
            if (std::ranges::all_of(more, [](std::uint64_t n) { return n == 0; })) return;
            add(more);
        }
    }
    Value of(const Quantity& quantity) const { return valueOf(quantity, readings_); }

  private:
    /// Further paths that each detector needs: the standard error decreases with the square root of
    /// their number. A detector of several quantities gets the largest number.
    SampleCounts missingSamples(const Effort& effort, double share) const {
        constexpr double kMargin = 1.2;
        SampleCounts more(readings_.size(), 0);
        for (const Quantity& quantity : trial_.quantities) {
            if (!quantity.expected) continue;
            const double target = share * effort.toleranceFactor * quantity.expected->tolerance;
            const double ratio = of(quantity).sigma / target;
            if (ratio <= 1.0) continue;
            const double growth = std::min(kMargin * ratio * ratio, kMaxGrowthPerRound);
            for (const Term& term : quantity.terms) {
                const std::uint64_t have = readings_[term.detector].samples;
                const auto want = std::min(
                    static_cast<std::uint64_t>(growth * static_cast<double>(have)), effort.most);
                more[term.detector] = std::max(more[term.detector], want - std::min(want, have));
            }
        }
        return more;
    }

    /// Measures detectors that need about the same number of paths together, because all detectors
    /// of one call get equally many.
    void add(const SampleCounts& more) {
        std::map<std::uint64_t, std::vector<std::size_t>> groups;
        for (std::size_t i = 0; i < more.size(); ++i) {
            if (more[i] > 0) groups[std::bit_ceil(more[i])].push_back(i);
        }
        for (const auto& [samples, members] : groups) {
            for (std::size_t k = 0; k < members.size(); k += kMaxDetectorsPerCall) {
                const std::size_t count = std::min(members.size() - k, kMaxDetectorsPerCall);
                addTogether(std::span(members).subspan(k, count), more);
            }
        }
    }

    void addTogether(std::span<const std::size_t> members, const SampleCounts& more) {
        std::vector<render::Detector> detectors;
        settings_.samples = 0;
        for (const std::size_t i : members) {
            detectors.push_back(trial_.detectors[i]);
            settings_.samples = std::max(settings_.samples, more[i]);
        }
        settings_.seed += 0x9E3779B9U;  // different paths in every call
        const auto read = meter_.measure(scene_, detectors, settings_, progress_);
        for (std::size_t k = 0; k < members.size(); ++k) {
            readings_[members[k]] = pooled(readings_[members[k]], read[k]);
        }
    }

    render::TraceMeter& meter_;
    const Trial& trial_;
    const render::MeterScene& scene_;
    render::MeterSettings settings_;
    const Progress& progress_;
    std::vector<Measured> readings_;
};

}  // namespace

std::vector<Row> runTrial(render::TraceMeter& meter, const Trial& trial, const Effort& effort,
                          const Progress& progress) {
    // A difference of two measurements has √2 times the standard error of each.
    const double share = effort.sigmaOverTolerance / (trial.twin ? std::sqrt(2.0) : 1.0);
    Measurement here(meter, trial, trial.scene, trial.settings, progress);
    here.run(effort, share);
    std::optional<Measurement> there;
    if (trial.twin) {
        render::MeterSettings other = trial.twin->settings;
        other.seed += 1;
        there.emplace(meter, trial, trial.twin->scene, other, progress);
        there->run(effort, share);
    }
    std::vector<Row> rows;
    for (const Quantity& quantity : trial.quantities) {
        const Value value = here.of(quantity);
        Row row{trial.name, quantity.name, trial.source, {},
                value.mean, value.sigma,   0.0,          value.samples};
        if (quantity.expected) {
            row.expected = quantity.expected->value;
            row.tolerance = quantity.expected->tolerance * effort.toleranceFactor;
            if (!quantity.expected->source.empty()) row.source = quantity.expected->source;
        }
        if (there) {
            const Value other = there->of(quantity);
            row.expected = other.mean;
            row.sigma = std::hypot(row.sigma, other.sigma);
            row.samples += other.samples;
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::optional<Row> allTogether(const std::vector<Row>& rows, const Effort& effort) {
    constexpr double kPreciseTolerance = 0.005;
    constexpr double kTolerance = 0.001;
    constexpr int kMinCount = 10;
    double sum = 0.0, weights = 0.0, variance = 0.0;
    int count = 0;
    for (const Row& row : rows) {
        if (!row.expected || *row.expected == 0.0) continue;
        const double scale = 1.0 / std::abs(*row.expected);
        const double tolerance = row.tolerance / effort.toleranceFactor * scale;
        if (tolerance > kPreciseTolerance) continue;
        const double sigma = row.sigma * scale;
        const double weight = 1.0 / (sigma * sigma + tolerance * tolerance);
        sum += weight * (row.measured - *row.expected) * scale;
        weights += weight;
        variance += weight * weight * sigma * sigma;
        ++count;
    }
    if (count < kMinCount) return {};
    Row all;
    all.trial = fmt::format("All together: {} of the above", count);
    all.source = "no bias";
    all.quantity = "mean relative difference";
    all.expected = 0.0;
    all.measured = sum / weights;
    all.sigma = std::sqrt(variance) / weights;
    all.tolerance = kTolerance * std::sqrt(effort.toleranceFactor);
    return all;
}

}  // namespace neph::validate
