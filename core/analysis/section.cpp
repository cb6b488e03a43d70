// section.cpp: samples columns along a line, and all columns at a height.
#include "core/analysis/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/analysis/air_block.h"
#include "core/analysis/place.h"
#include "core/base/error.h"

namespace neph {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr int kMostPoints = 800, kMostHeights = 250;
constexpr double kHeightStepM = 100.0;

/// The two cells along an axis between whose centres a position lies.
struct Neighbours {
    int lower = 0, upper = 0;
    double share = 0.0;
};

Neighbours neighboursOf(const DatasetInfo& info, int axis, double positionM) {
    const auto centre = [&](int cell) {
        return 0.5 * (info.edgeM(axis, cell) + info.edgeM(axis, cell + 1));
    };
    glm::dvec2 at(0.0);
    at[axis] = positionM;
    const int cell = columnAt(info, at)[axis];
    const int lower = std::max(positionM < centre(cell) ? cell - 1 : cell, 0);
    const int upper = std::min(lower + 1, info.size[axis] - 1);
    if (upper == lower) return {lower, lower, 0.0};
    const double share = (positionM - centre(lower)) / (centre(upper) - centre(lower));
    return {lower, upper, std::clamp(share, 0.0, 1.0)};
}

/// A point of a line, between four columns.
struct Point {
    Neighbours x, y;

    std::array<glm::ivec2, 4> columns() const {
        return {glm::ivec2(x.lower, y.lower), glm::ivec2(x.upper, y.lower),
                glm::ivec2(x.lower, y.upper), glm::ivec2(x.upper, y.upper)};
    }
    std::array<double, 4> shares() const {
        return {(1.0 - x.share) * (1.0 - y.share), x.share * (1.0 - y.share),
                (1.0 - x.share) * y.share, x.share * y.share};
    }
};

double groundAt(const AirBlock& block, const Point& point) {
    const auto columns = point.columns();
    const auto shares = point.shares();
    double ground = 0.0;
    for (std::size_t i = 0; i < 4; ++i) ground += shares[i] * block.faceM(columns[i], 0);
    return ground;
}

/// Columns that a height is below the ground of, or above the top of, leave their share to the
/// others.
float valueAt(const AirBlock& block, const Point& point, Quantity quantity, double heightM) {
    const auto columns = point.columns();
    const auto shares = point.shares();
    double sum = 0.0, weight = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (shares[i] <= 0.0) continue;
        const double value = block.valueAtHeight(quantity, columns[i], heightM);
        if (std::isnan(value)) continue;
        sum += shares[i] * value;
        weight += shares[i];
    }
    return weight > 0.0 ? static_cast<float>(sum / weight) : kNothing;
}

int pointsAlong(const DatasetInfo& info, double lengthM) {
    const double cell = std::min(info.spacingM.x, info.spacingM.y);
    return std::clamp(static_cast<int>(std::ceil(2.0 * lengthM / cell)) + 1, 2, kMostPoints);
}

/// Half of the thinnest layer of a column, and no more than kHeightStepM.
double heightStepOf(const AirBlock& block, glm::ivec2 column) {
    double step = kHeightStepM;
    for (int level = 0; level < block.levels(); ++level) {
        step = std::min(step, 0.5 * (block.faceM(column, level + 1) - block.faceM(column, level)));
    }
    return step;
}

/// Even heights from the lowest ground to the highest top.
std::vector<double> heightsOf(double lowestM, double highestM, double stepM) {
    const int steps = static_cast<int>(
        std::clamp(std::ceil((highestM - lowestM) / stepM), 2.0, double(kMostHeights)));
    std::vector<double> heights;
    for (int i = 0; i < steps; ++i) {
        heights.push_back(std::lerp(lowestM, highestM, (i + 0.5) / steps));
    }
    return heights;
}

/// The points of some rows of a section, which share a block of columns.
struct Stretch {
    std::size_t first = 0, end = 0;
    CellBox columns;
};

/// Points are taken together as long as their columns are few: a diagonal line through a large
/// domain would otherwise need all of it.
std::vector<Stretch> stretchesOf(const std::vector<Point>& points) {
    constexpr int kMostColumns = 4096;
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const CellBox own{{points[i].x.lower, points[i].y.lower, 0},
                          {points[i].x.upper + 1, points[i].y.upper + 1, 1}};
        if (!stretches.empty()) {
            Stretch& last = stretches.back();
            const CellBox both{glm::min(last.columns.lower, own.lower),
                               glm::max(last.columns.upper, own.upper)};
            if (both.size().x * both.size().y <= kMostColumns) {
                last.columns = both;
                last.end = i + 1;
                continue;
            }
        }
        stretches.push_back({i, i + 1, own});
    }
    return stretches;
}

void addTropopause(CrossSection& section, const AirBlock& block, const Point& point,
                   std::size_t i) {
    std::vector<double> heights, temperatures;
    for (int level = 0; level < block.levels(); ++level) {
        const glm::ivec3 cell{point.x.share < 0.5 ? point.x.lower : point.x.upper,
                              point.y.share < 0.5 ? point.y.lower : point.y.upper, level};
        heights.push_back(block.middleM(cell));
        temperatures.push_back(block.value(Quantity::temperature, cell));
    }
    section.tropopauseM[i] =
        tropopauseOf(heights, temperatures).value_or(std::numeric_limits<double>::quiet_NaN());
}

void fill(CrossSection& section, const AirBlock& block, const std::vector<Point>& points,
          const Stretch& stretch) {
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
        section.groundM[i] = groundAt(block, points[i]);
        if (!section.tropopauseM.empty()) addTropopause(section, block, points[i], i);
        for (SectionField& field : section.fields) {
            for (std::size_t k = 0; k < section.upM.size(); ++k) {
                if (section.upM[k] < section.groundM[i]) continue;
                field.values[k * section.acrossM.size() + i] =
                    valueAt(block, points[i], field.quantity, section.upM[k]);
            }
        }
    }
}

CrossSection emptySection(std::span<const Quantity> quantities) {
    CrossSection section;
    for (const Quantity quantity : quantities) section.fields.push_back({quantity, {}});
    return section;
}

void requireHeight(const Dataset& dataset, int time, const CrossSection& section, double lowestM,
                   double highestM) {
    for (const SectionField& field : section.fields) {
        const bool any = std::ranges::any_of(field.values, [](float v) { return !std::isnan(v); });
        if (any) return;
    }
    const TimeInfo& when = dataset.info().times.at(static_cast<std::size_t>(time));
    throw Error({.where = when.file.string(),
                 .what = "there is no air at that height",
                 .found = fmt::format("{:g} m above sea level", section.heightM),
                 .expected = fmt::format("{:.0f} to {:.0f} m", lowestM, highestM),
                 .hint = "give a height between the ground and the model's top"});
}

}  // namespace

std::optional<double> tropopauseOf(std::span<const double> heightsM,
                                   std::span<const double> temperaturesK) {
    constexpr double kLeastLapse = 2e-3, kDepthM = 2000.0, kLowestM = 5000.0;
    const std::size_t levels = heightsM.size();
    for (std::size_t i = 0; i + 1 < levels; ++i) {
        if (heightsM[i] < kLowestM || heightsM[i] + kDepthM > heightsM.back()) continue;
        bool stable = true;
        for (std::size_t k = i + 1; k < levels && heightsM[k] <= heightsM[i] + kDepthM; ++k) {
            const double lapse =
                (temperaturesK[i] - temperaturesK[k]) / (heightsM[k] - heightsM[i]);
            stable = stable && lapse < kLeastLapse;
        }
        if (stable) return heightsM[i];
    }
    return {};
}

CrossSection verticalSection(Dataset& dataset, int time, glm::dvec2 fromM, glm::dvec2 toM,
                             std::span<const Quantity> quantities, bool tropopause,
                             const Progress& progress) {
    const DatasetInfo& info = dataset.info();
    std::vector<Quantity> read(quantities.begin(), quantities.end());
    if (tropopause) read.push_back(Quantity::temperature);
    for (const Quantity quantity : read) requireQuantity(dataset, time, quantity);
    CrossSection section = emptySection(quantities);
    section.fromM = fromM;
    section.toM = toM;
    const double length = glm::length(toM - fromM);
    const int count = pointsAlong(info, length);
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        const double share = (i + 0.5) / count;
        const glm::dvec2 at = glm::mix(fromM, toM, share);
        section.acrossM.push_back(share * length);
        points.push_back({neighboursOf(info, 0, at.x), neighboursOf(info, 1, at.y)});
    }
    section.groundM.assign(points.size(), 0.0);
    if (tropopause) {
        section.tropopauseM.assign(points.size(), std::numeric_limits<double>::quiet_NaN());
    }
    const std::vector<Stretch> stretches = stretchesOf(points);
    for (std::size_t s = 0; s < stretches.size(); ++s) {
        const AirBlock block(dataset, time, stretches[s].columns, read);
        if (section.upM.empty()) {
            const glm::ivec2 column(stretches[s].columns.lower);
            // The lowest ground may be elsewhere along the line, sea level at the lowest.
            section.upM =
                heightsOf(std::min(block.faceM(column, 0), 0.0),
                          block.faceM(column, block.levels()), heightStepOf(block, column));
            for (SectionField& field : section.fields) {
                field.values.assign(section.upM.size() * points.size(), kNothing);
            }
        }
        fill(section, block, points, stretches[s]);
        if (!goOn(progress, static_cast<double>(s + 1) / static_cast<double>(stretches.size()))) {
            throw Cancelled{};
        }
    }
    return section;
}

CrossSection horizontalSection(Dataset& dataset, int time, double heightM,
                               std::span<const Quantity> quantities, const Progress& progress) {
    const DatasetInfo& info = dataset.info();
    for (const Quantity quantity : quantities) requireQuantity(dataset, time, quantity);
    CrossSection section = emptySection(quantities);
    section.vertical = false;
    section.heightM = heightM;
    for (int x = 0; x < info.size.x; ++x) section.acrossM.push_back(centreM(info, {x, 0}).x);
    for (int y = 0; y < info.size.y; ++y) section.upM.push_back(centreM(info, {0, y}).y);
    for (SectionField& field : section.fields) {
        field.values.assign(section.acrossM.size() * section.upM.size(), kNothing);
    }
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const CellBox& band : bandsOf(wholeBox(info), 1)) {
        const AirBlock block(dataset, time, band, quantities);
        for (int y = band.lower.y; y < band.upper.y; ++y) {
            for (int x = 0; x < info.size.x; ++x) {
                lowest = std::min(lowest, block.faceM({x, y}, 0));
                highest = std::max(highest, block.faceM({x, y}, block.levels()));
                for (SectionField& field : section.fields) {
                    field.values[static_cast<std::size_t>(y * info.size.x + x)] =
                        static_cast<float>(block.valueAtHeight(field.quantity, {x, y}, heightM));
                }
            }
        }
        if (!goOn(progress, static_cast<double>(band.upper.y) / info.size.y)) throw Cancelled{};
    }
    requireHeight(dataset, time, section, lowest, highest);
    return section;
}

CrossSection readSection(Dataset& dataset, int time, const SectionCut& cut,
                         const Progress& progress) {
    std::vector<Quantity> quantities{cut.shown};
    quantities.insert(quantities.end(), cut.contours.begin(), cut.contours.end());
    if (!cut.vertical) return horizontalSection(dataset, time, cut.heightM, quantities, progress);
    const bool temperature = lackOf(Quantity::temperature, dataset.infoAt(time)).empty();
    if (temperature) quantities.push_back(Quantity::temperature);
    CrossSection section =
        verticalSection(dataset, time, cut.fromM, cut.toM, quantities, temperature, progress);
    section.temperatureLast = temperature;
    return section;
}

}  // namespace neph
