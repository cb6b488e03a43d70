// info_command.cpp: the summary of a series, as text and as JSON (`type` nephoscope-info, version
// 1).
//
// Fields are read for their maxima: of every time of a short series, else of the first and the
// last.
#include "app/cli/info_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/dataset.h"
#include "core/file_list.h"
#include "core/statistics.h"

namespace neph {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kTimesReadInFull = 16;  // so that the answer comes within seconds
constexpr double kGramPerKg = 1e3;
constexpr double kKmPerM = 1e-3;

constexpr std::array<std::string_view, 8> kRoleIds{
    "other",        "mixing_ratio",    "dry_air_density",  "interface_height",
    "air_pressure", "air_temperature", "effective_radius", "number_concentration"};

std::vector<TimeSummary> summariseTimes(Dataset& dataset) {
    const int count = static_cast<int>(dataset.info().times.size());
    std::vector<int> times(static_cast<std::size_t>(std::min(count, kTimesReadInFull)));
    std::iota(times.begin(), times.end(), 0);
    if (count > kTimesReadInFull) times = {0, count - 1};
    std::vector<TimeSummary> summaries;
    summaries.reserve(times.size());
    for (int time : times) summaries.push_back(summarise(dataset, time));
    return summaries;
}

const TimeInfo& timeOf(const DatasetInfo& info, const TimeSummary& summary) {
    return info.times[static_cast<std::size_t>(summary.time)];
}

/// For each species the time at which it is densest.
struct Best {
    const TimeSummary* summary;
    const SpeciesPeak* peak;
};
std::vector<Best> bestPeaks(const std::vector<TimeSummary>& summaries) {
    std::vector<Best> best;
    for (std::size_t i = 0; i < summaries.front().peaks.size(); ++i) {
        Best entry{&summaries.front(), &summaries.front().peaks[i]};
        for (const TimeSummary& summary : summaries) {
            const SpeciesPeak& peak = summary.peaks[i];
            if (peak.ratioKgPerKg > entry.peak->ratioKgPerKg) entry = {&summary, &peak};
        }
        best.push_back(entry);
    }
    return best;
}

std::string gridLines(const DatasetInfo& info, const LayerSummary& layers) {
    return fmt::format(
        "Grid     {} x {} x {} cells of {:g} x {:g} m\n"
        "Domain   {:g} x {:g} km, heights {:.0f} m to {:.2f} km\n"
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
    std::string text = fmt::format("\n{:<9}{:>8}{:>9}{:>9}{:>11}   {}\n", "Maximum", "g/kg", "x km",
                                   "y km", "height km", "time");
    for (const Best& best : bestPeaks(summaries)) {
        const SpeciesPeak& peak = *best.peak;
        const std::string_view label = neph::info(peak.species).label;
        if (peak.ratioKgPerKg <= 0.0f) {
            text += fmt::format("{:<9}{:>8}\n", label, "none");
            continue;
        }
        const glm::dvec3 km = peak.positionM * kKmPerM;
        text += fmt::format("{:<9}{:>8.3g}{:>9.1f}{:>9.1f}{:>11.2f}   {}\n", label,
                            static_cast<double>(peak.ratioKgPerKg) * kGramPerKg, km.x, km.y, km.z,
                            timeOf(info, *best.summary).label);
    }
    return text;
}

/// A row of maxima for each time that was read.
std::string seriesLines(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    if (summaries.size() < 2 || summaries.front().peaks.empty()) return {};
    std::string text = fmt::format("\n{:<21}", "g/kg at");
    for (const SpeciesPeak& peak : summaries.front().peaks) {
        text += fmt::format("{:>9}", neph::info(peak.species).label);
    }
    for (const TimeSummary& summary : summaries) {
        text += fmt::format("\n{:<21}", timeOf(info, summary).label);
        for (const SpeciesPeak& peak : summary.peaks) {
            text += fmt::format("{:>9.3g}", static_cast<double>(peak.ratioKgPerKg) * kGramPerKg);
        }
    }
    return text + "\n";
}

std::vector<std::string> allNotes(const DatasetInfo& info,
                                  const std::vector<TimeSummary>& summaries) {
    std::vector<std::string> notes = info.notes;
    if (summaries.size() < info.times.size()) {
        notes.push_back(
            fmt::format("Maxima are of the first and the last of {} times.", info.times.size()));
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

Json timesJson(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    Json times = Json::array();
    for (const TimeInfo& time : info.times) {
        times.push_back({{"label", time.label},
                         {"seconds", time.seconds},
                         {"file", time.file.string()},
                         {"index_in_file", time.indexInFile}});
    }
    for (const TimeSummary& summary : summaries) {
        Json maxima = Json::array();
        for (const SpeciesPeak& peak : summary.peaks) maxima.push_back(peakJson(peak));
        times[static_cast<std::size_t>(summary.time)]["maxima"] = std::move(maxima);
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
std::string infoText(Dataset& dataset) {
    const DatasetInfo& info = dataset.info();
    const std::vector<TimeSummary> summaries = summariseTimes(dataset);
    std::string text = fmt::format("Model    {}\nScheme   {}\nReader   {}\n", info.model,
                                   info.scheme.empty() ? "unknown" : info.scheme, info.reader);
    text += gridLines(info, summaries.back().layers);
    text += timeLine(info);
    text += peakLines(info, summaries);
    text += seriesLines(info, summaries);
    const std::vector<std::string> notes = allNotes(info, summaries);
    if (!notes.empty()) text += fmt::format("\nNotes\n  {}\n", fmt::join(notes, "\n  "));
    return text;
}

/// The same and more for programs.
std::string infoJson(Dataset& dataset) {
    const DatasetInfo& info = dataset.info();
    const std::vector<TimeSummary> summaries = summariseTimes(dataset);
    Json species = Json::array();
    for (const Best& best : bestPeaks(summaries)) {
        Json json = peakJson(*best.peak);
        if (best.peak->ratioKgPerKg > 0.0f) json["time"] = timeOf(info, *best.summary).label;
        species.push_back(std::move(json));
    }
    const Json json{{"type", "nephoscope-info"},
                    {"version", 1},
                    {"reader", info.reader},
                    {"model", info.model},
                    {"scheme", info.scheme},
                    {"grid", gridJson(info, summaries.back().layers)},
                    {"species", std::move(species)},
                    {"times", timesJson(info, summaries)},
                    {"variables", variablesJson(info)},
                    {"attributes", info.attributes},
                    {"notes", allNotes(info, summaries)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

int runInfo(const InfoOptions& options) {
    const auto dataset =
        Dataset::open(listFiles(options.files), PluginHost::standard(options.readers));
    fmt::print("{}", options.json ? infoJson(*dataset) : infoText(*dataset));
    return 0;
}

}  // namespace neph
