// ask_run.cpp: opens the data, asks them, and writes plots and tables.
#include "app/cli/ask/ask_run.h"

#include <fmt/format.h>

#include <cmath>

#include "app/cli/ask/probe_text.h"
#include "app/cli/info/info_findings.h"
#include "app/image_io/figure_file.h"
#include "core/base/atomic_file.h"
#include "core/base/resources.h"
#include "core/dataset/file_list.h"
#include "core/plot/table.h"

namespace neph {
namespace {

/// Says what was left out or corrected, and which of the domains of a nested run is asked.
std::shared_ptr<Dataset> open(const AskedData& asked) {
    std::shared_ptr<Dataset> dataset =
        Dataset::open(listFiles(asked.files), PluginHost::standard(asked.readers, asked.map));
    for (const std::string& note : dataset->info().notes) fmt::print(stderr, "note: {}\n", note);
    if (!dataset->nests().empty()) {
        fmt::print(stderr,
                   "note: the outermost domain is asked; to ask a nest, open it by itself.\n");
    }
    return dataset;
}

int timeOf(const AskedData& asked, const DatasetInfo& info) {
    return timesOf(asked.times, info).front();
}

std::string timeLabel(const Dataset& dataset, int time) {
    return dataset.info().times.at(static_cast<std::size_t>(time)).label;
}

/// "55.0, 28.0 km (35.20 N 97.40 W)"
std::string positionText(const DatasetInfo& info, int time, glm::dvec2 atM) {
    const auto geo = geoOf(info, time, atM);
    return fmt::format("{:.1f}, {:.1f} km{}", atM.x * kKmPerM, atM.y * kKmPerM,
                       geo ? " (" + geoText(*geo) + ")" : "");
}

/// What a file says about where it comes from.
Metadata metadataOf(const Dataset& dataset, int time, const std::string& what) {
    const TimeInfo& when = dataset.info().times.at(static_cast<std::size_t>(time));
    return {{"Software", fmt::format("Nephoscope {}", versionText())},
            {"Source", when.file.string()},
            {"Model", dataset.info().model},
            {"Time", when.label},
            {"Description", what}};
}

/// Writes a sheet or a table, by the extension of each file, and says so.
void write(const AskedFiles& files, const Sheet& sheet, plot::Table table) {
    for (const auto& [key, value] : sheet.metadata) table.comments.push_back(key + ": " + value);
    for (const std::filesystem::path& file : files.out) {
        if (file.extension() == ".csv") {
            replaceFile(file, plot::csvOf(table));
        } else if (file.extension() == ".nc") {
            replaceFile(file, plot::netcdfOf(table, "time", sheet.metadata.back().second));
        } else {
            writeSheet(file, sheet);
        }
        fmt::print("wrote {}\n", file.string());
    }
}

/// "x 46.9, y 51.9 km" or "12.5 km along it, 9.25 km up".
std::string cellText(const CrossSection& section, std::size_t cell) {
    const double across = section.acrossM[cell % section.acrossM.size()] * kKmPerM;
    const double up = section.upM[cell / section.acrossM.size()] * kKmPerM;
    return section.vertical ? fmt::format("{:.1f} km along it, {:.2f} km up", across, up)
                            : fmt::format("x {:.1f}, y {:.1f} km", across, up);
}

/// The greatest and the least of what a section shows, and where.
void printExtremes(const CrossSection& section, std::size_t fields) {
    for (std::size_t f = 0; f < fields; ++f) {
        const SectionField& field = section.fields[f];
        std::optional<std::size_t> least, greatest;
        for (std::size_t i = 0; i < field.values.size(); ++i) {
            const float value = field.values[i];
            if (std::isnan(value)) continue;
            if (!least || value < field.values[*least]) least = i;
            if (!greatest || value > field.values[*greatest]) greatest = i;
        }
        if (!least) continue;
        const QuantityInfo& row = neph::info(field.quantity);
        fmt::print("{}, {}: greatest {:.4g} at {}; least {:.4g} at {}\n", row.label, row.unit,
                   field.values[*greatest], cellText(section, *greatest), field.values[*least],
                   cellText(section, *least));
    }
}

glm::dvec2 sizeOr(const AskedFiles& files, glm::dvec2 own) {
    return files.sizePx.x > 0 ? glm::dvec2(files.sizePx) : own;
}

}  // namespace

int runProbe(const ProbeRequest& request) {
    const auto dataset = open(request.data);
    const int time = timeOf(request.data, dataset->info());
    const glm::dvec2 at = positionOf(request.place, *dataset, time, "--at");
    const ColumnReport report = readColumn(*dataset, time, at);
    fmt::print("{}", request.json ? probeJson(*dataset, report) : probeText(*dataset, report));
    return 0;
}

int runProfile(const ProfileRequest& request) {
    const auto dataset = open(request.data);
    const int time = timeOf(request.data, dataset->info());
    const glm::dvec2 at = positionOf(request.place, *dataset, time, "--at");
    const ColumnReport report = readColumn(*dataset, time, at);
    for (const std::string& lack : report.lacks) fmt::print(stderr, "note: {}\n", lack);
    const std::string where = positionText(dataset->info(), time, report.positionM);
    const std::string when = timeLabel(*dataset, time);
    Sheet sheet;
    const bool sounding = report.sounding.has_value(), wind = report.wind.has_value();
    sheet.sizePt = sizeOr(request.files, {sounding ? 1180.0 : 520.0, 620.0});
    sheet.metadata = metadataOf(*dataset, time, "Column at " + where);
    const double left = sounding ? 0.66 * sheet.sizePt.x : 0.0;
    const double middle = wind ? 0.5 * sheet.sizePt.y : 0.0;
    if (sounding) {
        sheet.figures.push_back({skewTFigure(report, request.source, where, when),
                                 {{0.0, 0.0}, {left, sheet.sizePt.y}}});
    }
    if (wind) {
        sheet.figures.push_back({hodographFigure(report), {{left, 0.0}, {sheet.sizePt.x, middle}}});
    }
    sheet.figures.push_back({profileFigure(report, sounding ? "Hydrometeors" : where + ", " + when),
                             {{left, middle}, sheet.sizePt}});
    write(request.files, sheet, columnTable(report));
    return 0;
}

int runSection(const SectionRequest& request) {
    const auto dataset = open(request.data);
    const DatasetInfo& info = dataset->info();
    const int time = timeOf(request.data, info);
    SectionCut cut{.vertical = !request.heightM,
                   .heightM = request.heightM.value_or(0.0),
                   .shown = request.shown,
                   .contours = request.contours};
    const std::string title =
        fmt::format("{}, {}", neph::info(request.shown).label, neph::info(request.shown).unit);
    std::string subtitle = timeLabel(*dataset, time);
    if (cut.vertical) {
        cut.fromM = positionOf(*request.from, *dataset, time, "--from");
        cut.toM = positionOf(*request.to, *dataset, time, "--to");
        if (glm::distance(cut.fromM, cut.toM) < 1.0) {
            throw UsageError({"--to", "is where --from is", "", "two places", ""});
        }
        subtitle += fmt::format(", from {} to {}", positionText(info, time, cut.fromM),
                                positionText(info, time, cut.toM));
    } else {
        subtitle += fmt::format(", {:g} m above sea level", cut.heightM);
    }
    const CrossSection section = readSection(*dataset, time, cut);
    Sheet sheet;
    sheet.sizePt = sizeOr(request.files,
                          section.vertical ? glm::dvec2(900.0, 480.0) : glm::dvec2(720.0, 640.0));
    sheet.metadata = metadataOf(*dataset, time, title + ", " + subtitle);
    sheet.figures.push_back(
        {sectionFigure(section, request.limits, title, subtitle), {{0.0, 0.0}, sheet.sizePt}});
    printExtremes(section, section.fields.size() - (section.temperatureLast ? 1 : 0));
    write(request.files, sheet, sectionTable(section));
    return 0;
}

int runSeries(const SeriesRequest& request) {
    const auto dataset = open(request.data);
    const int count = static_cast<int>(dataset->info().times.size());
    const TimeRange all{0, count - 1, ""};
    const std::vector<int> times = timesOf(request.data.times.value_or(all), dataset->info());
    std::vector<SeriesPoint> points;
    std::vector<std::string> labels;
    for (const int time : times) {
        points.push_back(readSeriesPoint(*dataset, time));
        labels.push_back(timeLabel(*dataset, time));
    }
    std::vector<SeriesKind> kinds;
    for (int i = 0; i < kSeriesKinds; ++i) {
        const auto kind = static_cast<SeriesKind>(i);
        if (!request.kind || *request.kind == kind) kinds.push_back(kind);
    }
    Sheet sheet;
    constexpr double kHeightPt = 240.0;
    sheet.sizePt =
        sizeOr(request.files, {800.0, kHeightPt * static_cast<double>(kinds.size()) + 60.0});
    sheet.metadata =
        metadataOf(*dataset, times.front(), "Series of " + labels.front() + " to " + labels.back());
    const double height = sheet.sizePt.y / static_cast<double>(kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const double top = height * static_cast<double>(i);
        const std::string title = i == 0 ? labels.front() + " to " + labels.back() : "";
        sheet.figures.push_back(
            {seriesFigure(points, kinds[i], title), {{0.0, top}, {sheet.sizePt.x, top + height}}});
    }
    write(request.files, sheet, seriesTable(points, labels));
    return 0;
}

}  // namespace neph
