// info_text.cpp: the summary for people.
#include "app/cli/info/info_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "app/cli/info/info_findings.h"
#include "app/cli/info/info_members.h"
#include "app/cli/info/info_place.h"
#include "app/cli/info/info_shown.h"
#include "core/dataset/grid_text.h"
#include "core/dataset/nest_place.h"
#include "core/look/haze.h"
#include "core/sky/humidity.h"

namespace neph {
namespace {

std::string gridLines(const DatasetInfo& info, const LayerSummary& layers) {
    const glm::dvec2 extentKm = info.extentM() * kKmPerM;
    return fmt::format(
        "Grid     {} x {} x {} cells of {}\n"
        "Domain   {:.4g} x {:.4g} km, heights {:.0f} m to {:.2f} km\n"
        "Layers   {}, {:.0f} to {:.0f} m deep, median {:.0f} m\n",
        info.size.x, info.size.y, info.size.z, cellWidthText(info), extentKm.x, extentKm.y,
        layers.lowestM, layers.highestM * kKmPerM, info.size.z, layers.thinnestM, layers.thickestM,
        layers.medianM);
}

/// The domains of a nested run; nothing for one.
std::string domainLines(const Dataset& dataset) {
    if (dataset.nests().empty()) return {};
    const auto line = [](std::string_view label, std::string_view name, const DatasetInfo& info) {
        return fmt::format("{:<9}{}: {} x {} x {} cells of {}", label, name, info.size.x,
                           info.size.y, info.size.z, cellWidthText(info));
    };
    const DatasetInfo& outer = dataset.info();
    const std::string name = domainName(outer);
    std::string text = line("Domains", name.empty() ? "outermost" : name, outer) + "\n";
    for (const Nest& nest : dataset.nests()) {
        const auto first = std::ranges::find_if(nest.at, [](const auto& at) { return !!at; });
        const auto count = std::ranges::count_if(nest.at, [](const auto& at) { return !!at; });
        const glm::dvec2 cornerKm = nest.cornerM(outer, **first) * kKmPerM;
        text += fmt::format("{}, from x {:.4g} km, y {:.4g} km{}, at {} of {} times\n",
                            line("", nest.name, nest.dataset->info()), cornerKm.x, cornerKm.y,
                            nest.moves() ? " (it moves)" : "", count, nest.at.size());
    }
    return text;
}

std::string timeLine(const DatasetInfo& info) {
    const auto& times = info.times;
    if (times.size() == 1) return fmt::format("Time     {}\n", times.front().label);
    const double span = times.back().seconds - times.front().seconds;
    return fmt::format("Times    {}: {} to {}, {}, {}\n", times.size(), times.front().label,
                       times.back().label, minutesText(span), timeStepText(info));
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
                       range->baseM * kKmPerM, range->topM * kKmPerM, of, kCloudRatioGPerKg);
}

std::string kmText(const BaseRange& range) {
    const std::string from = fmt::format("{:.2f}", range.leastM * kKmPerM);
    const std::string to = fmt::format("{:.2f}", range.mostM * kKmPerM);
    return from == to ? from + " km" : fmt::format("{} to {} km", from, to);
}

/// Bases of columns: over several times, from the lowest to the highest.
std::string basesLine(const std::vector<TimeSummary>& summaries) {
    const auto low = rangeOf(summaries, &CloudBases::lowM);
    const auto middle = rangeOf(summaries, &CloudBases::middleM);
    const auto updraft = rangeOf(summaries, &CloudBases::updraftM);
    if (!low || !middle || !updraft) return {};
    const std::string wind = updraftVariable(summaries);
    return fmt::format(
        "Bases    of cloudy columns: {:.0f}th percentile {}, median {}; main updraft ({}) {}\n",
        100.0 * CloudBases::kLowShare, kmText(*low), kmText(*middle),
        wind.empty() ? "columns with most condensate" : wind, kmText(*updraft));
}

std::string rangeLines(const std::vector<TimeSummary>& summaries) {
    if (summaries.front().peaks.empty()) return {};
    return "\n" +
           rangeLine("Cloud", rangeOf(summaries, &TimeSummary::cloud), "cloud water and ice") +
           basesLine(summaries) +
           rangeLine("Precip", rangeOf(summaries, &TimeSummary::precipitation),
                     "rain, snow, graupel and hail");
}

/// "29.7", or "29.7 to 31.6".
std::string spanText(double least, double most, int digits) {
    const std::string from = fmt::format("{:.{}g}", least, digits);
    const std::string to = fmt::format("{:.{}g}", most, digits);
    return from == to ? from : fmt::format("{} to {}", from, to);
}

/// The humidity of the lowest air, and what haze makes of it.
std::string humidityLine(const std::vector<TimeSummary>& summaries) {
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const TimeSummary& summary : summaries) {
        const auto& humidity = summary.lowestAir.humidity;
        if (!humidity) continue;
        least = std::min(least, *humidity);
        most = std::max(most, *humidity);
    }
    const std::string& reason = summaries.front().lowestAir.reason;
    if (least > most) return fmt::format("Humidity not known: {}\n", reason);
    return fmt::format(
        "Humidity {} % in the lowest layer; visibility by it (sky.haze=humidity) {} km\n",
        spanText(100.0 * least, 100.0 * most, 2),
        spanText(visibilityOfHumidityM(most) * kKmPerM, visibilityOfHumidityM(least) * kKmPerM, 3));
}

/// The same of its aerosol; nothing where the data have none.
std::string aerosolLine(const std::vector<TimeSummary>& summaries) {
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const TimeSummary& summary : summaries) {
        const auto& perM = summary.lowestAir.aerosolPerM;
        if (!perM) continue;
        least = std::min(least, *perM);
        most = std::max(most, *perM);
    }
    if (least > most) return {};
    return fmt::format(
        "Aerosol  extinction {} per Mm in the lowest layer; visibility by it (sky.haze=aerosol) {} "
        "km\n",
        spanText(1e6 * least, 1e6 * most, 3),
        spanText(visibilityOfAerosolM(most) * kKmPerM, visibilityOfAerosolM(least) * kKmPerM, 3));
}

std::string kmOf(const std::optional<HeightRange>& range, double HeightRange::*end) {
    return range ? fmt::format("{:.2f}", (*range).*end * kKmPerM) : "none";
}

std::string kmOf(const std::optional<CloudBases>& bases, double CloudBases::*base) {
    return bases ? fmt::format("{:.2f}", (*bases).*base * kKmPerM) : "none";
}

/// A row for each time that was read: maxima, cloud bases and top. A species that a time lacks has
/// a dash.
std::string seriesLines(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    if (summaries.size() < 2 || summaries.front().peaks.empty()) return {};
    std::string text = fmt::format("\n{:<21}", "g/kg at");
    for (const SpeciesPeak& peak : summaries.front().peaks) {
        text += fmt::format("{:>9}", neph::info(peak.species).label);
    }
    text += fmt::format("{:>9}{:>9}{:>9}{:>9}{:>9}", "base km", "5 %", "50 %", "updraft", "top km");
    for (const TimeSummary& summary : summaries) {
        text += fmt::format("\n{:<21}", timeOf(info, summary).label);
        for (const SpeciesPeak& peak : summary.peaks) {
            text +=
                peak.variable.empty()
                    ? fmt::format("{:>9}", "-")
                    : fmt::format("{:>9.3g}", static_cast<double>(peak.ratioKgPerKg) * kGramPerKg);
        }
        text += fmt::format(
            "{:>9}{:>9}{:>9}{:>9}{:>9}", kmOf(summary.cloud, &HeightRange::baseM),
            kmOf(summary.bases, &CloudBases::lowM), kmOf(summary.bases, &CloudBases::middleM),
            kmOf(summary.bases, &CloudBases::updraftM), kmOf(summary.cloud, &HeightRange::topM));
    }
    return text + "\n";
}

}  // namespace

std::string infoText(Dataset& dataset, const std::optional<TimeRange>& times,
                     const MemoryBudget& budget) {
    const DatasetInfo& info = dataset.info();
    const TimeSummaries found = summariseTimes(dataset, times);
    const std::vector<TimeSummary>& summaries = found.read;
    std::string text = fmt::format("Model    {}\nScheme   {}\nReader   {}\n", info.model,
                                   info.scheme.empty() ? "unknown" : info.scheme, info.reader);
    text += gridLines(info, summaries.back().layers);
    text += domainLines(dataset) + membersLines(dataset) + timeLine(info) + placeLines(info);
    text += fmt::format("Shown    {}\n", shownHere(dataset, summaries.back().time, budget));
    text += peakLines(info, summaries) + columnLines(info, summaries) + rangeLines(summaries);
    text += humidityLine(summaries) + aerosolLine(summaries);
    text += seriesLines(info, summaries) + motionLines(info) + sunLines(info, summaries);
    const std::vector<std::string> notes = allNotes(info, found);
    if (!notes.empty()) text += fmt::format("\nNotes\n  {}\n", fmt::join(notes, "\n  "));
    return text;
}

}  // namespace neph
