// info_findings.cpp: reads the times, and compares them.
#include "app/cli/info/info_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "core/base/error.h"

namespace neph {
namespace {

// Values that are read unasked: some seconds, measured at 10 ns a value.
constexpr double kMostValues = 4e8;

/// The times that are read.
std::vector<int> timesToRead(const DatasetInfo& info, const std::optional<TimeRange>& asked) {
    if (asked) return timesOf(asked, info);
    const auto count = static_cast<int>(info.times.size());
    const auto ratios =
        std::ranges::count(info.variables, VariableRole::mixingRatio, &VariableInfo::role);
    const glm::dvec3 size(info.size);
    const double values = size.x * size.y * size.z * static_cast<double>(ratios) * count;
    if (count > 2 && values > kMostValues) return {0, count - 1};
    std::vector<int> times(static_cast<std::size_t>(count));
    std::iota(times.begin(), times.end(), 0);
    return times;
}

/// What `of` finds in each summary, where `value` is greatest.
template <typename Of, typename Value>
auto greatest(const std::vector<TimeSummary>& summaries, Of of, Value value) {
    using Found = std::remove_cvref_t<decltype(of(summaries.front()))>;
    At<Found> best{&of(summaries.front()), &summaries.front()};
    for (const TimeSummary& summary : summaries) {
        if (value(of(summary)) > value(*best.found)) best = {&of(summary), &summary};
    }
    return best;
}

double massOf(const ColumnPeak& column) {
    return column.massKgPerM2;
}

}  // namespace

TimeSummaries summariseTimes(Dataset& dataset, const std::optional<TimeRange>& asked) {
    TimeSummaries summaries;
    std::optional<Error> first;
    for (int time : timesToRead(dataset.info(), asked)) {
        try {
            summaries.read.push_back(summarise(dataset, time));
        } catch (const Error& error) {
            if (!first) first = error;
            const std::string& label = dataset.info().times[static_cast<std::size_t>(time)].label;
            summaries.refused.push_back(fmt::format("{} cannot be shown: {} ({}).", label,
                                                    error.parts().what, error.parts().found));
        }
    }
    if (summaries.read.empty()) throw *first;
    return summaries;
}

const TimeInfo& timeOf(const DatasetInfo& info, const TimeSummary& summary) {
    return info.times[static_cast<std::size_t>(summary.time)];
}

std::vector<At<SpeciesPeak>> densest(const std::vector<TimeSummary>& summaries) {
    std::vector<At<SpeciesPeak>> best;
    for (std::size_t i = 0; i < summaries.front().peaks.size(); ++i) {
        best.push_back(greatest(
            summaries, [i](const TimeSummary& s) -> const SpeciesPeak& { return s.peaks[i]; },
            [](const SpeciesPeak& peak) {
                return peak.variable.empty() ? -1.0f : peak.ratioKgPerKg;
            }));
    }
    return best;
}

At<ColumnPeak> heaviest(const std::vector<TimeSummary>& summaries, std::size_t species) {
    return greatest(
        summaries,
        [=](const TimeSummary& s) -> const ColumnPeak& { return s.peaks[species].column; }, massOf);
}

At<ColumnPeak> heaviest(const std::vector<TimeSummary>& summaries) {
    return greatest(
        summaries, [](const TimeSummary& s) -> const ColumnPeak& { return s.condensate; }, massOf);
}

std::optional<HeightRange> rangeOf(const std::vector<TimeSummary>& summaries,
                                   std::optional<HeightRange> TimeSummary::*range) {
    std::optional<HeightRange> all;
    for (const TimeSummary& summary : summaries) {
        const std::optional<HeightRange>& one = summary.*range;
        if (!one) continue;
        if (!all) all = one;
        all->baseM = std::min(all->baseM, one->baseM);
        all->topM = std::max(all->topM, one->topM);
    }
    return all;
}

std::optional<BaseRange> rangeOf(const std::vector<TimeSummary>& summaries,
                                 double CloudBases::*base) {
    std::optional<BaseRange> all;
    for (const TimeSummary& summary : summaries) {
        if (!summary.bases) continue;
        const double one = (*summary.bases).*base;
        if (!all) all = BaseRange{one, one};
        all->leastM = std::min(all->leastM, one);
        all->mostM = std::max(all->mostM, one);
    }
    return all;
}

std::string updraftVariable(const std::vector<TimeSummary>& summaries) {
    for (const TimeSummary& summary : summaries) {
        if (summary.bases) return summary.bases->updraftVariable;
    }
    return {};
}

std::vector<std::string> allNotes(const DatasetInfo& info, const TimeSummaries& summaries) {
    std::vector<std::string> notes = info.notes;
    notes.insert(notes.end(), summaries.refused.begin(), summaries.refused.end());
    const std::size_t tried = summaries.read.size() + summaries.refused.size();
    if (tried < info.times.size()) {
        notes.push_back(fmt::format("{} of {} times were read; --time all reads every one.", tried,
                                    info.times.size()));
    }
    for (const TimeSummary& summary : summaries.read) {
        const std::string& label = timeOf(info, summary).label;
        for (const std::string& note : summary.notes) {
            notes.push_back(fmt::format("{}: {}", label, note));
        }
        const bool empty = std::ranges::all_of(
            summary.peaks, [](const SpeciesPeak& peak) { return peak.ratioKgPerKg <= 0.0f; });
        if (empty && !summary.peaks.empty()) {
            notes.push_back(label + ": no condensate, every mixing ratio is zero.");
        }
    }
    return notes;
}

}  // namespace neph
