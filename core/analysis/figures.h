// figures.h: sections, columns and series as plots, and as tables of their numbers.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/analysis/column.h"
#include "core/analysis/section.h"
#include "core/analysis/series.h"
#include "core/plot/figure.h"
#include "core/plot/table.h"

namespace neph {

/// Limits of colours; where one is not given it follows from the values.
struct ColourLimits {
    std::optional<double> from, to;
};

/// The first field in colours, the others as contours.
plot::Figure sectionFigure(const CrossSection& section, const ColourLimits& limits,
                           const std::string& title, const std::string& subtitle);
plot::Table sectionTable(const CrossSection& section);

/// Skew-T log-p of a sounding with the way of a parcel, and barbs of wind on its right side.
plot::Figure skewTFigure(const ColumnReport& report, ParcelSource source, const std::string& title,
                         const std::string& subtitle);
/// Wind over height as a curve, with how storms move. The report has wind.
plot::Figure hodographFigure(const ColumnReport& report);
/// What floats in the column, g/kg over height.
plot::Figure profileFigure(const ColumnReport& report, const std::string& title);
plot::Table columnTable(const ColumnReport& report);

/// What a series shows.
enum class SeriesKind : int { contents, updraft, heights, masses, cover };
inline constexpr int kSeriesKinds = 5;
std::string_view idOf(SeriesKind kind);

plot::Figure seriesFigure(std::span<const SeriesPoint> points, SeriesKind kind,
                          const std::string& title);
/// `labels` are those of the times of all points.
plot::Table seriesTable(std::span<const SeriesPoint> points,
                        const std::vector<std::string>& labels);

}  // namespace neph
