// checks_phase.cpp: Kolmogorov-Smirnov test of the scattering angles that paths sample.
// [Knuth98] 3.3.1
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/validate/checks.h"
#include "core/optics/phase_functions.h"

namespace neph::validate {
namespace {

constexpr double kFalseAlarmProbability = 1e-4;  // of rejecting a correct sampler

/// Kolmogorov-Smirnov statistic D: the largest distance between the empirical distribution of
/// cosines and the exact one.
double distance(std::vector<float> cosines, const PhaseSpec& spec) {
    std::ranges::sort(cosines);
    const auto count = static_cast<double>(cosines.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < cosines.size(); ++i) {
        const double theta = std::acos(std::clamp(static_cast<double>(cosines[i]), -1.0, 1.0));
        const double below =
            1.0 - static_cast<double>(phaseCumulative(spec, static_cast<float>(theta)));
        const auto n = static_cast<double>(i);
        largest = std::max({largest, below - n / count, (n + 1.0) / count - below});
    }
    return largest;
}

}  // namespace

std::vector<Row> phaseRows(render::TraceMeter& meter, bool quick) {
    const int count = quick ? 1 << 16 : 1 << 20;
    std::vector<Row> rows;
    for (const PhaseSpec& spec : typicalSpecs()) {
        const auto kind = static_cast<std::size_t>(spec.kind);
        Row row;
        row.trial = fmt::format("Phase functions: {} scattering angles drawn", count);
        row.source =
            fmt::format("cumulative of the phase function, p = {}", kFalseAlarmProbability);
        row.quantity = fmt::format("D of {}", phaseFunction(spec.kind).id);
        row.expected = 0.0;
        const auto seed = static_cast<std::uint32_t>(1 + kind);
        row.measured = distance(meter.sampledCosines(spec, count, seed), spec);
        // Asymptotic critical value of D.
        row.tolerance = std::sqrt(-0.5 * std::log(kFalseAlarmProbability / 2.0) / count);
        row.samples = static_cast<std::uint64_t>(count);
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace neph::validate
