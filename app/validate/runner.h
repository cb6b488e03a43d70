// runner.h: measures a trial until its standard errors are small enough to judge by.
#pragma once
#include <cstdint>
#include <vector>

#include "app/validate/trial.h"

namespace neph::validate {

/// How much work is done. Seeds follow from the trials' names, so a run can be repeated.
struct Effort {
    double toleranceFactor = 1.0;     ///< on every tolerance
    std::uint64_t first = 0;          ///< paths a detector, before it is known how many are needed
    std::uint64_t most = 0;           ///< paths a detector
    double sigmaOverTolerance = 0.9;  ///< that is aimed at
};
inline constexpr Effort kFullEffort{1.0, std::uint64_t{1} << 15, std::uint64_t{1} << 24, 0.9};
inline constexpr Effort kQuickEffort{10.0, std::uint64_t{1} << 10, std::uint64_t{1} << 20, 0.9};

/// Throws Cancelled and what the meter throws.
std::vector<Row> runTrial(render::TraceMeter& meter, const Trial& trial, const Effort& effort,
                          const Progress& progress);

/// The mean relative difference of all that is expected to half a per cent or better: a bias too
/// small to be seen in any one of them. Those that are better known do not count for more than
/// their tolerance is worth. None where there are fewer than ten.
std::optional<Row> allTogether(const std::vector<Row>& rows, const Effort& effort);

}  // namespace neph::validate
