// ensemble_drawing.cpp: the words and the scale of each map.
#include "core/volume/ensemble_drawing.h"

#include <fmt/format.h>

namespace neph {

MapImage drawEnsembleMap(const EnsembleDepths& depths, EnsembleMap map, double threshold,
                         int widthPx) {
    constexpr double kKmPerMetre = 1e-3;
    const std::vector<float> values = mapOf(depths, map, threshold);
    const bool share = map == EnsembleMap::probability;
    const RegularGrid& grid = depths.grid;
    return drawMap(
        {.size = {grid.size.x, grid.size.y},
         .values = values,
         .originKm = glm::dvec2(grid.originM) * kKmPerMetre,
         .cellKm = glm::dvec2(grid.spacingM) * kKmPerMetre,
         .widthPx = widthPx,
         .most = share ? 1.0 : roundMost(values),
         .title = titleOf(map, threshold),
         .subtitle = fmt::format("{}, {} members", depths.timeLabel, depths.members.size()),
         .label = share ? "probability" : "optical depth"});
}

}  // namespace neph
