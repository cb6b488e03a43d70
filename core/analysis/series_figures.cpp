// series_figures.cpp: a run over time as plots and a table.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/analysis/figures.h"

namespace neph {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kMinute = 60.0;

/// One curve of a series: how its value is found in a point.
struct Line {
    std::string label;
    plot::Ink ink;
    double (*value)(const SeriesPoint& point, std::size_t species);
    std::size_t species = 0;
};

constexpr std::array kInks{plot::Ink::foreground, plot::Ink::cyan,   plot::Ink::blue,
                           plot::Ink::orange,     plot::Ink::purple, plot::Ink::red};

double valueOf(const std::optional<Extreme>& extreme) {
    return extreme ? extreme->value : kNone;
}

std::vector<Line> ofSpecies(std::span<const SeriesPoint> points,
                            double (*value)(const SeriesPoint&, std::size_t)) {
    std::vector<Line> lines;
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const bool any = std::ranges::any_of(
            points, [&](const SeriesPoint& point) { return point.mostGPerKg[s].has_value(); });
        if (any) lines.push_back({std::string(kSpecies[s].label), kInks[s], value, s});
    }
    return lines;
}

std::vector<Line> linesOf(std::span<const SeriesPoint> points, SeriesKind kind) {
    using P = const SeriesPoint&;
    switch (kind) {
        case SeriesKind::contents:
            return ofSpecies(points, [](P p, std::size_t s) { return valueOf(p.mostGPerKg[s]); });
        case SeriesKind::masses:
            return ofSpecies(points,
                             [](P p, std::size_t s) { return 1e-9 * p.massKg[s].value_or(kNone); });
        case SeriesKind::updraft:
            return {{"Updraft", plot::Ink::red,
                     [](P p, std::size_t) { return valueOf(p.updraftMPerS); }},
                    {"Downdraft", plot::Ink::blue,
                     [](P p, std::size_t) { return valueOf(p.downdraftMPerS); }}};
        case SeriesKind::heights:
            return {{"Storm top", plot::Ink::foreground,
                     [](P p, std::size_t) { return 1e-3 * p.stormTopM.value_or(kNone); }},
                    {"Base (5 % of cloudy columns)", plot::Ink::blue,
                     [](P p, std::size_t) { return 1e-3 * p.baseM.value_or(kNone); }}};
        case SeriesKind::cover:
            break;
    }
    return {
        {"Cloud cover", plot::Ink::foreground, [](P p, std::size_t) { return 100.0 * p.cover; }}};
}

constexpr std::array<std::string_view, kSeriesKinds> kIds{"contents", "updraft", "heights",
                                                          "masses", "cover"};
constexpr std::array<const char*, kSeriesKinds> kAxes{
    "Largest mixing ratio, g/kg", "Largest upward and downward wind, m/s",
    "Height above sea level, km", "Mass in the domain, 10⁹ kg", "Area under cloud, %"};

/// Columns of an extreme: its value and where it is.
void addExtreme(plot::Table& table, std::span<const SeriesPoint> points, const std::string& name,
                const std::string& unit, const auto& extremeOf) {
    const bool any = std::ranges::any_of(
        points, [&](const SeriesPoint& point) { return extremeOf(point).has_value(); });
    if (!any) return;
    plot::Column value{fmt::format("{} [{}]", name, unit), {}, {}};
    std::array<plot::Column, 3> at;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        at[axis].name = fmt::format("{} at {} [m]", name, "xyz"[axis]);
    }
    for (const SeriesPoint& point : points) {
        const std::optional<Extreme>& extreme = extremeOf(point);
        value.numbers.push_back(valueOf(extreme));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            at[axis].numbers.push_back(
                extreme ? extreme->positionM[static_cast<glm::length_t>(axis)] : kNone);
        }
    }
    table.columns.push_back(std::move(value));
    for (plot::Column& column : at) table.columns.push_back(std::move(column));
}

void addNumber(plot::Table& table, std::span<const SeriesPoint> points, const std::string& name,
               const auto& numberOf) {
    plot::Column column{name, {}, {}};
    for (const SeriesPoint& point : points) column.numbers.push_back(numberOf(point));
    const bool any =
        std::ranges::any_of(column.numbers, [](double number) { return std::isfinite(number); });
    if (any) table.columns.push_back(std::move(column));
}

}  // namespace

std::string_view idOf(SeriesKind kind) {
    return kIds[static_cast<std::size_t>(kind)];
}

plot::Figure seriesFigure(std::span<const SeriesPoint> points, SeriesKind kind,
                          const std::string& title) {
    plot::Figure figure;
    figure.title = title;
    double least = 0.0, greatest = 0.0;
    for (const Line& line : linesOf(points, kind)) {
        plot::Curve curve;
        curve.label = line.label;
        curve.ink = line.ink;
        for (const SeriesPoint& point : points) {
            const double value = line.value(point, line.species);
            curve.points.push_back({point.seconds / kMinute, value});
            if (!std::isfinite(value)) continue;
            least = std::min(least, value);
            greatest = std::max(greatest, value);
        }
        figure.curves.push_back(std::move(curve));
    }
    if (!(greatest > least)) greatest = least + 1.0;
    const double room = 0.05 * (greatest - least);
    const double first = points.front().seconds / kMinute, last = points.back().seconds / kMinute;
    figure.x = {"Time, min", first, last > first ? last : first + 1.0, false, {}};
    figure.y = {kAxes[static_cast<std::size_t>(kind)],
                least < 0.0 ? least - room : 0.0,
                greatest + room,
                false,
                {}};
    return figure;
}

plot::Table seriesTable(std::span<const SeriesPoint> points,
                        const std::vector<std::string>& labels) {
    plot::Table table;
    plot::Column label{"time", {}, labels}, seconds{"seconds [s]", {}, {}};
    for (const SeriesPoint& point : points) seconds.numbers.push_back(point.seconds);
    table.columns = {std::move(label), std::move(seconds)};
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const std::string id(kSpecies[s].id);
        addExtreme(
            table, points, id + " max",
            "g/kg", [&](const SeriesPoint& point) -> const auto& { return point.mostGPerKg[s]; });
        addNumber(table, points, id + " mass [kg]",
                  [&](const SeriesPoint& point) { return point.massKg[s].value_or(kNone); });
    }
    addExtreme(
        table, points, "w max", "m/s",
        [](const SeriesPoint& point) -> const auto& { return point.updraftMPerS; });
    addExtreme(
        table, points, "w min", "m/s",
        [](const SeriesPoint& point) -> const auto& { return point.downdraftMPerS; });
    addExtreme(
        table, points, "reflectivity max", "dBZ",
        [](const SeriesPoint& point) -> const auto& { return point.reflectivityDbz; });
    addNumber(table, points, "storm top [m]",
              [](const SeriesPoint& point) { return point.stormTopM.value_or(kNone); });
    addNumber(table, points, "cloud base [m]",
              [](const SeriesPoint& point) { return point.baseM.value_or(kNone); });
    addNumber(table, points, "cloud cover [1]",
              [](const SeriesPoint& point) { return point.cover; });
    return table;
}

}  // namespace neph
