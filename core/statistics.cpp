// statistics.cpp: maxima of mixing ratios and the depths of layers.
#include "core/statistics.h"

#include <algorithm>
#include <iterator>

#include "core/repair.h"
#include "core/resample.h"

namespace neph {
namespace {

LayerSummary summariseLayers(const Array3f& heights) {
    LayerSummary layers;
    const auto [lowest, highest] = std::ranges::minmax(heights.values);
    layers.lowestM = static_cast<double>(lowest);
    layers.highestM = static_cast<double>(highest);
    layers.medianM = medianLayerDepth(heights);
    const std::size_t layer = heights.index(0, 0, 1);
    float thinnest = heights.values[layer] - heights.values[0];
    float thickest = thinnest;
    for (std::size_t i = layer; i < heights.values.size(); ++i) {
        const float depth = heights.values[i] - heights.values[i - layer];
        thinnest = std::min(thinnest, depth);
        thickest = std::max(thickest, depth);
    }
    layers.thinnestM = static_cast<double>(thinnest);
    layers.thickestM = static_cast<double>(thickest);
    return layers;
}

SpeciesPeak findPeak(const Array3f& ratio, const Array3f& heights, glm::dvec2 spacingM) {
    SpeciesPeak peak;
    const auto highest = std::ranges::max_element(ratio.values);
    const auto index = static_cast<std::size_t>(std::distance(ratio.values.begin(), highest));
    const std::size_t layer = ratio.index(0, 0, 1);
    const std::size_t column = index % layer;
    const auto width = static_cast<std::size_t>(ratio.size.x);
    peak.ratioKgPerKg = *highest;
    peak.positionM.x = (static_cast<double>(column % width) + 0.5) * spacingM.x;
    const std::size_t row = column / width;
    peak.positionM.y = (static_cast<double>(row) + 0.5) * spacingM.y;
    // Interfaces have one level more and the same layers: index is the one below, index + layer
    // that above.
    peak.positionM.z = 0.5 * (static_cast<double>(heights.values[index]) +
                              static_cast<double>(heights.values[index + layer]));
    return peak;
}

}  // namespace

TimeSummary summarise(Dataset& dataset, int time, const Progress& progress) {
    TimeSummary summary;
    summary.time = time;
    const Array3f heights = readInterfaceHeights(dataset, time);
    summary.layers = summariseLayers(heights);
    for (int s = 0; s < kSpeciesCount; ++s) {
        if (!goOn(progress, static_cast<double>(s) / kSpeciesCount)) throw Cancelled{};
        const auto species = static_cast<Species>(s);
        const VariableInfo* variable = dataset.info().find(VariableRole::mixingRatio, species);
        if (variable == nullptr || variable->size != dataset.info().size) continue;
        Array3f ratio = dataset.read(variable->name, time);
        std::ranges::move(describe(repair(ratio), variable->name),
                          std::back_inserter(summary.notes));
        SpeciesPeak peak = findPeak(ratio, heights, dataset.info().spacingM);
        peak.species = species;
        peak.variable = variable->name;
        summary.peaks.push_back(std::move(peak));
    }
    return summary;
}

}  // namespace neph
