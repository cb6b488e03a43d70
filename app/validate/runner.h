// runner.h: measures a trial until its standard errors are small enough for a verdict.
#pragma once
#include <cstdint>
#include <vector>

#include "app/validate/trial.h"

namespace neph::validate {

/// How much work is done. Seeds are derived from the names of the trials, so a run can be repeated.
struct Effort {
    double toleranceFactor = 1.0;     ///< multiplies every tolerance
    std::uint64_t first = 0;          ///< paths per detector of the first round
    std::uint64_t most = 0;           ///< paths per detector at most
    double sigmaOverTolerance = 0.9;  ///< target for the standard errors
};
inline constexpr Effort kFullEffort{1.0, std::uint64_t{1} << 15, std::uint64_t{1} << 24, 0.9};
inline constexpr Effort kQuickEffort{10.0, std::uint64_t{1} << 10, std::uint64_t{1} << 20, 0.9};

/// One row per quantity of the trial. Throws Cancelled and what the meter throws.
std::vector<Row> runTrial(render::TraceMeter& meter, const Trial& trial, const Effort& effort,
                          const Progress& progress);

/// Mean relative difference of all quantities expected to half a per cent or better, which shows a
/// bias too small to be seen in any one of them. The weights are 1 / (σ² + tolerance²), so that a
/// quantity counts for no more than its tolerance allows. Nothing for fewer than ten quantities.
std::optional<Row> allTogether(const std::vector<Row>& rows, const Effort& effort);

}  // namespace neph::validate
