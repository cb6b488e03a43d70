// info_command.cpp: the summary of a series, as text and as JSON (`type` nephoscope-info, version
// 1).
//
// Fields are read for their maxima: of the times asked for, else of every time when that takes
// seconds, else of the first and the last.
#include "app/cli/info/info_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "app/cli/common/scene.h"
#include "app/cli/info/info_shown.h"
#include "core/dataset/dataset.h"
#include "core/dataset/file_list.h"
#include "core/volume/read_plan.h"
#include "core/volume/statistics.h"

namespace neph {
namespace {

using Json = nlohmann::ordered_json;

// Values that are read unasked: some seconds, measured at 10 ns a value.
constexpr double kMostValues = 4e8;
constexpr double kGramPerKg = 1e3;
constexpr double kKmPerM = 1e-3;

constexpr std::array<std::string_view, 8> kRoleIds{
    "other",        "mixing_ratio",    "dry_air_density",  "interface_height",
    "air_pressure", "air_temperature", "effective_radius", "number_concentration"};

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

std::vector<TimeSummary> summariseTimes(Dataset& dataset, const std::optional<TimeRange>& asked) {
    std::vector<TimeSummary> summaries;
    for (int time : timesToRead(dataset.info(), asked)) {
        summaries.push_back(summarise(dataset, time));
    }
    return summaries;
}

const TimeInfo& timeOf(const DatasetInfo& info, const TimeSummary& summary) {
    return info.times[static_cast<std::size_t>(summary.time)];
}

/// Something that was found, and at which of the times.
template <typename T>
struct At {
    const T* found;
    const TimeSummary* when;
};

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

/// For each species the time at which it is densest.
std::vector<At<SpeciesPeak>> densest(const std::vector<TimeSummary>& summaries) {
    std::vector<At<SpeciesPeak>> best;
    for (std::size_t i = 0; i < summaries.front().peaks.size(); ++i) {
        best.push_back(greatest(
            summaries, [i](const TimeSummary& s) -> const SpeciesPeak& { return s.peaks[i]; },
            [](const SpeciesPeak& peak) { return peak.ratioKgPerKg; }));
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

/// From the lowest base to the highest top of all times.
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

std::string gridLines(const DatasetInfo& info, const LayerSummary& layers) {
    return fmt::format(
        "Grid     {} x {} x {} cells of {:.5g} x {:.5g} m\n"
        "Domain   {:.4g} x {:.4g} km, heights {:.0f} m to {:.2f} km\n"
        "Layers   {}, {:.0f} to {:.0f} m deep, median {:.0f} m\n",
        info.size.x, info.size.y, info.size.z, info.spacingM.x, info.spacingM.y,
        info.size.x * info.spacingM.x * kKmPerM, info.size.y * info.spacingM.y * kKmPerM,
        layers.lowestM, layers.highestM * kKmPerM, info.size.z, layers.thinnestM, layers.thickestM,
        layers.medianM);
}

std::string timeLine(const DatasetInfo& info) {
    const auto& times = info.times;
    if (times.size() == 1) return fmt::format("Time     {}\n", times.front().label);
    const double minutes = times.back().seconds / 60.0;
    return fmt::format("Times    {}: {} to {}, {:g} min, every {:g} min on average\n", times.size(),
                       times.front().label, times.back().label, minutes,
                       minutes / static_cast<double>(times.size() - 1));
}

std::string peakLines(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    if (summaries.front().peaks.empty()) return "\nNo hydrometeors in this file.\n";
    std::string text = fmt::format("\n{:<10}{:>8}{:>9}{:>9}{:>11}   {}\n", "Maximum", "g/kg",
                                   "x km", "y km", "height km", "time");
    for (const auto& [peak, when] : densest(summaries)) {
        const std::string_view label = neph::info(peak->species).label;
        if (peak->ratioKgPerKg <= 0.0f) {
            text += fmt::format("{:<10}{:>8}\n", label, "none");
            continue;
        }
        const glm::dvec3 km = peak->positionM * kKmPerM;
        text += fmt::format("{:<10}{:>8.3g}{:>9.1f}{:>9.1f}{:>11.2f}   {}\n", label,
                            static_cast<double>(peak->ratioKgPerKg) * kGramPerKg, km.x, km.y, km.z,
                            timeOf(info, *when).label);
    }
    return text;
}

std::string columnLine(const DatasetInfo& info, std::string_view label, const At<ColumnPeak>& at) {
    if (at.found->massKgPerM2 <= 0.0) return {};
    const glm::dvec2 km = at.found->positionM * kKmPerM;
    return fmt::format("{:<10}{:>8.3g}{:>9.1f}{:>9.1f}{:>11}   {}\n", label, at.found->massKgPerM2,
                       km.x, km.y, "", timeOf(info, *at.when).label);
}

std::string columnLines(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    std::string text;
    for (std::size_t i = 0; i < summaries.front().peaks.size(); ++i) {
        text += columnLine(info, neph::info(summaries.front().peaks[i].species).label,
                           heaviest(summaries, i));
    }
    text += columnLine(info, "All", heaviest(summaries));
    if (text.empty()) return {};
    return fmt::format("\n{:<10}{:>8}{:>9}{:>9}\n", "Column", "kg/m2", "x km", "y km") + text;
}

std::string rangeLine(std::string_view label, const std::optional<HeightRange>& range,
                      std::string_view of) {
    if (!range) return fmt::format("{:<9}none\n", label);
    return fmt::format("{:<9}base {:.2f} km, top {:.2f} km ({} above {:g} g/kg)\n", label,
                       range->baseM * kKmPerM, range->topM * kKmPerM, of,
                       static_cast<double>(kCloudRatioKgPerKg) * kGramPerKg);
}

std::string rangeLines(const std::vector<TimeSummary>& summaries) {
    if (summaries.front().peaks.empty()) return {};
    return "\n" +
           rangeLine("Cloud", rangeOf(summaries, &TimeSummary::cloud), "cloud water and ice") +
           rangeLine("Precip", rangeOf(summaries, &TimeSummary::precipitation),
                     "rain, snow, graupel and hail");
}

std::string kmOf(const std::optional<HeightRange>& range, double HeightRange::*end) {
    return range ? fmt::format("{:.2f}", (*range).*end * kKmPerM) : "none";
}

/// A row for each time that was read: maxima, cloud base and top.
std::string seriesLines(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    if (summaries.size() < 2 || summaries.front().peaks.empty()) return {};
    std::string text = fmt::format("\n{:<21}", "g/kg at");
    for (const SpeciesPeak& peak : summaries.front().peaks) {
        text += fmt::format("{:>9}", neph::info(peak.species).label);
    }
    text += fmt::format("{:>9}{:>9}", "base km", "top km");
    for (const TimeSummary& summary : summaries) {
        text += fmt::format("\n{:<21}", timeOf(info, summary).label);
        for (const SpeciesPeak& peak : summary.peaks) {
            text += fmt::format("{:>9.3g}", static_cast<double>(peak.ratioKgPerKg) * kGramPerKg);
        }
        text += fmt::format("{:>9}{:>9}", kmOf(summary.cloud, &HeightRange::baseM),
                            kmOf(summary.cloud, &HeightRange::topM));
    }
    return text + "\n";
}

std::vector<std::string> allNotes(const DatasetInfo& info,
                                  const std::vector<TimeSummary>& summaries) {
    std::vector<std::string> notes = info.notes;
    if (summaries.size() < info.times.size()) {
        notes.push_back(fmt::format("{} of {} times were read; --time all reads every one.",
                                    summaries.size(), info.times.size()));
    }
    for (const TimeSummary& summary : summaries) {
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

Json gridJson(const DatasetInfo& info, const LayerSummary& layers) {
    return {{"size", {info.size.x, info.size.y, info.size.z}},
            {"spacing_m", {info.spacingM.x, info.spacingM.y}},
            {"domain_km",
             {info.size.x * info.spacingM.x * kKmPerM, info.size.y * info.spacingM.y * kKmPerM}},
            {"height_m", {layers.lowestM, layers.highestM}},
            {"layer_depth_m",
             {{"thinnest", layers.thinnestM},
              {"median", layers.medianM},
              {"thickest", layers.thickestM}}}};
}

Json columnJson(const ColumnPeak& column) {
    Json json{{"maximum_kg_per_m2", column.massKgPerM2}};
    if (column.massKgPerM2 > 0.0) {
        json["x_km"] = column.positionM.x * kKmPerM;
        json["y_km"] = column.positionM.y * kKmPerM;
    }
    return json;
}

Json peakJson(const SpeciesPeak& peak) {
    Json json{{"species", neph::info(peak.species).id},
              {"variable", peak.variable},
              {"maximum_g_per_kg", static_cast<double>(peak.ratioKgPerKg) * kGramPerKg}};
    if (peak.ratioKgPerKg > 0.0f) {
        json["x_km"] = peak.positionM.x * kKmPerM;
        json["y_km"] = peak.positionM.y * kKmPerM;
        json["height_km"] = peak.positionM.z * kKmPerM;
    }
    return json;
}

/// Null where there is none.
Json rangeJson(const std::optional<HeightRange>& range) {
    if (!range) return nullptr;
    return {{"base_km", range->baseM * kKmPerM}, {"top_km", range->topM * kKmPerM}};
}

/// What one time holds.
Json summaryJson(const TimeSummary& summary) {
    Json maxima = Json::array();
    for (const SpeciesPeak& peak : summary.peaks) {
        maxima.push_back(peakJson(peak));
        if (summary.hasColumns) maxima.back()["column"] = columnJson(peak.column);
    }
    Json json{{"maxima", std::move(maxima)},
              {"cloud", rangeJson(summary.cloud)},
              {"precipitation", rangeJson(summary.precipitation)}};
    if (summary.hasColumns) json["condensate"] = columnJson(summary.condensate);
    return json;
}

Json timesJson(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    Json times = Json::array();
    for (const TimeInfo& time : info.times) {
        times.push_back({{"label", time.label},
                         {"seconds", time.seconds},
                         {"file", time.file.string()},
                         {"index_in_file", time.indexInFile}});
    }
    for (const TimeSummary& summary : summaries) {
        times[static_cast<std::size_t>(summary.time)].update(summaryJson(summary));
    }
    return times;
}

Json variablesJson(const DatasetInfo& info) {
    Json variables = Json::array();
    for (const VariableInfo& variable : info.variables) {
        Json json{{"name", variable.name},
                  {"standard_name", variable.standardName},
                  {"units", variable.units},
                  {"description", variable.description},
                  {"role", kRoleIds.at(static_cast<std::size_t>(variable.role))},
                  {"size", {variable.size.x, variable.size.y, variable.size.z}}};
        if (variable.species) json["species"] = neph::info(*variable.species).id;
        variables.push_back(std::move(json));
    }
    return variables;
}

/// The summary for people.
std::string infoText(Dataset& dataset, const std::optional<TimeRange>& times,
                     const MemoryBudget& budget) {
    const DatasetInfo& info = dataset.info();
    const std::vector<TimeSummary> summaries = summariseTimes(dataset, times);
    std::string text = fmt::format("Model    {}\nScheme   {}\nReader   {}\n", info.model,
                                   info.scheme.empty() ? "unknown" : info.scheme, info.reader);
    text += gridLines(info, summaries.back().layers);
    text += timeLine(info);
    text += fmt::format("Shown    {}\n", shownHere(dataset, summaries.back().time, budget));
    text += peakLines(info, summaries) + columnLines(info, summaries) + rangeLines(summaries);
    text += seriesLines(info, summaries);
    const std::vector<std::string> notes = allNotes(info, summaries);
    if (!notes.empty()) text += fmt::format("\nNotes\n  {}\n", fmt::join(notes, "\n  "));
    return text;
}

/// Extremes over all times that were read, each with its time.
Json speciesJson(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    Json species = Json::array();
    for (const auto& [peak, when] : densest(summaries)) {
        Json json = peakJson(*peak);
        if (peak->ratioKgPerKg > 0.0f) json["time"] = timeOf(info, *when).label;
        if (when->hasColumns) {
            const At<ColumnPeak> column = heaviest(summaries, species.size());
            json["column"] = columnJson(*column.found);
            if (column.found->massKgPerM2 > 0.0) {
                json["column"]["time"] = timeOf(info, *column.when).label;
            }
        }
        species.push_back(std::move(json));
    }
    return species;
}

Json condensateJson(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    const At<ColumnPeak> column = heaviest(summaries);
    Json json = columnJson(*column.found);
    if (column.found->massKgPerM2 > 0.0) json["time"] = timeOf(info, *column.when).label;
    return json;
}

/// The same and more for programs.
std::string infoJson(Dataset& dataset, const std::optional<TimeRange>& times,
                     const MemoryBudget& budget) {
    const DatasetInfo& info = dataset.info();
    const std::vector<TimeSummary> summaries = summariseTimes(dataset, times);
    Json json{{"type", "nephoscope-info"},
              {"version", 1},
              {"reader", info.reader},
              {"model", info.model},
              {"scheme", info.scheme},
              {"grid", gridJson(info, summaries.back().layers)},
              {"shown", shownHere(dataset, summaries.back().time, budget)},
              {"cloud_threshold_g_per_kg", static_cast<double>(kCloudRatioKgPerKg) * kGramPerKg},
              {"cloud", rangeJson(rangeOf(summaries, &TimeSummary::cloud))},
              {"precipitation", rangeJson(rangeOf(summaries, &TimeSummary::precipitation))},
              {"species", speciesJson(info, summaries)},
              {"times", timesJson(info, summaries)},
              {"variables", variablesJson(info)},
              {"attributes", info.attributes},
              {"notes", allNotes(info, summaries)}};
    if (summaries.front().hasColumns) json["condensate"] = condensateJson(info, summaries);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

int runInfo(const InfoRequest& request) {
    std::vector<std::string> warnings;
    const MemoryBudget budget = chooseBudget(request.memory, MemoryBudget{}.gpu, warnings);
    for (const std::string& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);
    const auto dataset =
        Dataset::open(listFiles(request.files), PluginHost::standard(request.readers));
    fmt::print("{}", request.json ? infoJson(*dataset, request.times, budget)
                                  : infoText(*dataset, request.times, budget));
    return 0;
}

}  // namespace neph
