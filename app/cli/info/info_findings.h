// info_findings.h: what the summaries of several times amount to.
#pragma once
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "app/cli/common/scene.h"
#include "core/dataset/dataset.h"
#include "core/volume/statistics.h"

namespace neph {

inline constexpr double kGramPerKg = 1e3;
inline constexpr double kKmPerM = 1e-3;

/// The times that were read, at least one, and a sentence for each that was refused.
struct TimeSummaries {
    std::vector<TimeSummary> read;
    std::vector<std::string> refused;
};

/// The times asked for, else every time when that takes seconds, else the first and the last.
/// Throws Error if all of them are refused.
TimeSummaries summariseTimes(Dataset& dataset, const std::optional<TimeRange>& asked);

const TimeInfo& timeOf(const DatasetInfo& info, const TimeSummary& summary);

/// Something that was found, and at which of the times.
template <typename T>
struct At {
    const T* found;
    const TimeSummary* when;
};

/// For each species the time at which it is densest.
std::vector<At<SpeciesPeak>> densest(const std::vector<TimeSummary>& summaries);

/// The heaviest column of a species, by its place among the peaks, or of all together.
At<ColumnPeak> heaviest(const std::vector<TimeSummary>& summaries, std::size_t species);
At<ColumnPeak> heaviest(const std::vector<TimeSummary>& summaries);

/// From the lowest base to the highest top of all times.
std::optional<HeightRange> rangeOf(const std::vector<TimeSummary>& summaries,
                                   std::optional<HeightRange> TimeSummary::*range);

/// From the lowest to the highest that a kind of cloud base has been at, metres.
struct BaseRange {
    double leastM, mostM;
};
/// Of the times with cloud; empty if there are none.
std::optional<BaseRange> rangeOf(const std::vector<TimeSummary>& summaries,
                                 double CloudBases::*base);
/// The variable by which the main updraft was found; empty if by condensate, or without cloud.
std::string updraftVariable(const std::vector<TimeSummary>& summaries);

/// Notes of the series, and of its times, which each of them names.
std::vector<std::string> allNotes(const DatasetInfo& info, const TimeSummaries& summaries);

}  // namespace neph
