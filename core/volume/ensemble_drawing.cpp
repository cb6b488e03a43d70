// ensemble_drawing.cpp: the words and the scale of each map.
#include "core/volume/ensemble_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace neph {
namespace {

/// Faces of the columns along an axis, km.
std::vector<double> edgesKm(const RegularGrid& grid, int axis) {
    std::vector<double> edges;
    for (int i = 0; i <= grid.size[axis]; ++i) {
        edges.push_back(1e-3 * (grid.originM[axis] + i * grid.spacingM[axis]));
    }
    return edges;
}

/// The smallest of 1, 2 or 5 times a power of ten that no value exceeds; 1 where all are 0.
double roundMost(const std::vector<float>& values) {
    float most = 0.0f;
    for (const float value : values) {
        if (value > most) most = value;
    }
    if (most <= 0.0f) return 1.0;
    const double decade = std::pow(10.0, std::floor(std::log10(static_cast<double>(most))));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (static_cast<double>(most) <= step * decade) return step * decade;
    }
    return 10.0 * decade;
}

}  // namespace

plot::Figure ensembleFigure(const EnsembleDepths& depths, EnsembleMap map, double threshold) {
    const bool share = map == EnsembleMap::probability;
    plot::Field field;
    field.values = mapOf(depths, map, threshold);
    field.label = share ? "Probability" : "Optical depth";
    field.edgesX = edgesKm(depths.grid, 0);
    field.edgesY = edgesKm(depths.grid, 1);
    field.to = share ? 1.0 : roundMost(field.values);
    plot::Figure figure;
    figure.title = titleOf(map, threshold);
    // The reasons would not fit: files have them.
    const std::string scale = depths.scale.substr(0, depths.scale.find(':'));
    figure.subtitle =
        fmt::format("{}, {} members, {}", depths.timeLabel, depths.members.size(), scale);
    figure.x = {"x, km", field.edgesX.front(), field.edgesX.back(), false, {}};
    figure.y = {"y, km", field.edgesY.front(), field.edgesY.back(), false, {}};
    figure.equalScale = true;
    figure.field = std::move(field);
    return figure;
}

}  // namespace neph
