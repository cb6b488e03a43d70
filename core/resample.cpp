// resample.cpp: conservative remapping of columns, one species at a time so that little is held at
// once.
#include "core/resample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/error.h"
#include "core/repair.h"

namespace neph {
namespace {

void requireSize(const Dataset& dataset, const VariableInfo& variable, int extraLevels) {
    const glm::ivec3 expected = dataset.info().size + glm::ivec3(0, 0, extraLevels);
    if (variable.size == expected) return;
    const auto text = [](glm::ivec3 s) { return fmt::format("{} x {} x {}", s.x, s.y, s.z); };
    throw Error({.where = dataset.info().times.front().file.string(),
                 .what = fmt::format("variable {} does not lie on the grid", variable.name),
                 .found = text(variable.size),
                 .expected = text(expected)});
}

const VariableInfo& required(const Dataset& dataset, VariableRole role, std::string_view meaning) {
    if (const VariableInfo* variable = dataset.info().find(role)) {
        requireSize(dataset, *variable, role == VariableRole::interfaceHeight ? 1 : 0);
        return *variable;
    }
    throw Error({.where = dataset.info().times.front().file.string(),
                 .what = fmt::format("{} cannot be had from this file", meaning),
                 .expected = "a variable of that role from the reader"});
}

Error badCell(const Dataset& dataset, int time, const VariableInfo& variable, glm::ivec3 cell,
              float value, std::string expected) {
    const TimeInfo& when = dataset.info().times.at(static_cast<std::size_t>(time));
    return Error({.where = when.file.string(),
                  .what = fmt::format("variable {} is unusable at {}", variable.name, when.label),
                  .found = fmt::format("{} in cell x {}, y {}, level {} ({})", value, cell.x,
                                       cell.y, cell.z, variable.description),
                  .expected = std::move(expected),
                  .hint = "the run blew up or the file is damaged: leave this time out"});
}

glm::ivec3 cellOf(const Array3f& array, std::size_t index) {
    const auto width = static_cast<std::size_t>(array.size.x);
    const std::size_t layer = width * static_cast<std::size_t>(array.size.y);
    return {static_cast<int>(index % width), static_cast<int>(index % layer / width),
            static_cast<int>(index / layer)};
}

Array3f readDensity(Dataset& dataset, int time, const Progress& progress) {
    const VariableInfo& variable =
        required(dataset, VariableRole::dryAirDensity, "the density of dry air");
    Array3f density = dataset.read(variable.name, time, {}, progress);
    for (std::size_t i = 0; i < density.values.size(); ++i) {
        const float value = density.values[i];
        if (!std::isfinite(value) || value <= 0.0f) {
            throw badCell(dataset, time, variable, cellOf(density, i), value, "above 0 kg/m3");
        }
    }
    return density;
}

/// The largest number with two digits that is not above `value`; value > 0.
double roundedDown(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::floor(value / unit + 1e-9) * unit;
}

RegularGrid gridFor(const DatasetInfo& info, const Array3f& heights,
                    const ResampleOptions& options) {
    const auto [lowest, highest] = std::ranges::minmax(heights.values);
    double bottom = static_cast<double>(lowest);
    double top = static_cast<double>(highest);
    RegularGrid grid;
    grid.spacingM = {info.spacingM.x, info.spacingM.y, 0.0};
    int levels = options.levels;
    if (levels <= 0) {
        const int most = std::max(options.maxLevels, 1);
        double spacing = roundedDown(medianLayerDepth(heights));
        const auto count = [&] {
            return std::ceil(top / spacing - 1e-6) - std::floor(bottom / spacing + 1e-6);
        };
        if (count() > most) spacing = (top - bottom) / std::max(most - 2, 1);
        bottom = spacing * std::floor(bottom / spacing + 1e-6);
        levels = std::clamp(static_cast<int>(std::ceil((top - bottom) / spacing - 1e-6)), 1, most);
        top = std::max(top, bottom + spacing * levels);
    }
    grid.spacingM.z = (top - bottom) / levels;
    grid.originM = {0.0, 0.0, bottom};
    grid.size = {info.size.x, info.size.y, levels};
    return grid;
}

/// Remaps every column of one species.
Array3f remap(const Array3f& heights, const Array3f& density, const Array3f& ratio,
              const RegularGrid& grid, const Progress& progress) {
    Array3f out(grid.size);
    const auto layers = static_cast<std::size_t>(ratio.size.z);
    const std::size_t layer = ratio.values.size() / layers;
    std::vector<double> interfaces(layers + 1);
    std::vector<double> content(layers);
    std::vector<double> target(static_cast<std::size_t>(grid.size.z));
    for (std::size_t column = 0; column < layer; ++column) {
        if (column % 16384 == 0 &&
            !goOn(progress, static_cast<double>(column) / static_cast<double>(layer))) {
            throw Cancelled{};
        }
        bool empty = true;
        for (std::size_t k = 0; k < layers; ++k) {
            const std::size_t i = column + k * layer;
            content[k] =
                static_cast<double>(ratio.values[i]) * static_cast<double>(density.values[i]);
            empty = empty && ratio.values[i] == 0.0f;
        }
        if (empty) continue;
        for (std::size_t k = 0; k <= layers; ++k) {
            interfaces[k] = static_cast<double>(heights.values[column + k * layer]);
        }
        std::ranges::fill(target, 0.0);
        resampleColumn(interfaces, content, grid.originM.z, grid.spacingM.z, target);
        for (std::size_t k = 0; k < target.size(); ++k) {
            out.values[column + k * layer] = static_cast<float>(target[k]);
        }
    }
    return out;
}

/// Part `index` of `parts` of the whole work.
Progress partOf(const Progress& progress, int index, int parts) {
    if (!progress) return {};
    return [=](double fraction) { return progress((index + fraction) / parts); };
}

/// Slope of content within layer k, per metre: the smaller of the slopes to its neighbours, and
/// never so steep that the line leaves the range of the neighbours' means (van Leer's limiter on
/// uneven layers).
double limitedSlope(std::span<const double> interfaces, std::span<const double> content,
                    std::size_t k) {
    if (k == 0 || k + 1 == content.size()) return 0.0;
    const double below = content[k] - content[k - 1];
    const double above = content[k + 1] - content[k];
    if (below * above <= 0.0) return 0.0;
    const double depth = interfaces[k + 1] - interfaces[k];
    const double reach = 0.5 * (interfaces[k + 2] + interfaces[k + 1] - interfaces[k] -
                                interfaces[k - 1]);  // centre below to centre above
    const double central = std::abs(below + above) / reach;
    const double steepest = 2.0 * std::min(std::abs(below), std::abs(above)) / depth;
    return std::copysign(std::min(central, steepest), below);
}

}  // namespace

Array3f readInterfaceHeights(Dataset& dataset, int time, const Progress& progress) {
    const VariableInfo& variable =
        required(dataset, VariableRole::interfaceHeight, "the height of layers");
    Array3f heights = dataset.read(variable.name, time, {}, progress);
    const std::size_t layer = heights.values.size() / static_cast<std::size_t>(heights.size.z);
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const float value = heights.values[i];
        if (!std::isfinite(value)) {
            throw badCell(dataset, time, variable, cellOf(heights, i), value, "heights in metres");
        }
        if (i >= layer && !(value > heights.values[i - layer])) {
            throw badCell(
                dataset, time, variable, cellOf(heights, i), value,
                fmt::format("more than the {} of the level below", heights.values[i - layer]));
        }
    }
    return heights;
}

double medianLayerDepth(const Array3f& heights) {
    const std::size_t layer = heights.values.size() / static_cast<std::size_t>(heights.size.z);
    const std::size_t count = heights.values.size() - layer;
    // Of large fields every n-th layer is looked at: about 100,000 tell the median well.
    std::size_t stride = std::max<std::size_t>(1, count / 100'000);
    if (stride > 1) stride |= 1U;  // odd, so that it does not fall in step with rows
    std::vector<float> depths;
    for (std::size_t i = 0; i < count; i += stride) {
        depths.push_back(heights.values[i + layer] - heights.values[i]);
    }
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::ranges::nth_element(depths, middle);
    return static_cast<double>(*middle);
}

void resampleColumn(std::span<const double> interfacesM, std::span<const double> content,
                    double bottomM, double spacingM, std::span<double> target) {
    const double perSpacing = 1.0 / spacingM;
    const auto last = static_cast<std::ptrdiff_t>(target.size()) - 1;
    for (std::size_t k = 0; k < content.size(); ++k) {
        if (content[k] == 0.0) continue;
        const double lower = interfacesM[k];
        const double upper = interfacesM[k + 1];
        const double centre = 0.5 * (lower + upper);
        const double slope = limitedSlope(interfacesM, content, k);
        const double first = std::floor((lower - bottomM) * perSpacing);
        auto cell = first > 0.0 ? static_cast<std::ptrdiff_t>(first) : 0;
        for (; cell <= last; ++cell) {
            const double cellLower = bottomM + spacingM * static_cast<double>(cell);
            if (cellLower >= upper) break;
            const double from = std::max(lower, cellLower);
            const double to = std::min(upper, cellLower + spacingM);
            if (to <= from) continue;
            const double mean = content[k] + slope * (0.5 * (from + to) - centre);
            target[static_cast<std::size_t>(cell)] += mean * (to - from) * perSpacing;
        }
    }
}

RegularGrid chooseGrid(Dataset& dataset, int time, const ResampleOptions& options) {
    return gridFor(dataset.info(), readInterfaceHeights(dataset, time, {}), options);
}

SpeciesVolume resample(Dataset& dataset, int time, const ResampleOptions& options,
                       const Progress& progress) {
    const DatasetInfo& info = dataset.info();
    std::vector<const VariableInfo*> ratios;
    for (int s = 0; s < kSpeciesCount; ++s) {
        const auto* ratio = info.find(VariableRole::mixingRatio, static_cast<Species>(s));
        if (ratio != nullptr) ratios.push_back(ratio);
    }
    const int parts = 2 + 2 * static_cast<int>(ratios.size());
    const Array3f heights = readInterfaceHeights(dataset, time, partOf(progress, 0, parts));
    const Array3f density = readDensity(dataset, time, partOf(progress, 1, parts));
    SpeciesVolume volume;
    volume.grid = gridFor(info, heights, options);
    volume.timeLabel = info.times.at(static_cast<std::size_t>(time)).label;
    volume.timeSeconds = info.times.at(static_cast<std::size_t>(time)).seconds;
    std::vector<std::string> empty;
    int part = 2;
    for (const VariableInfo* variable : ratios) {
        requireSize(dataset, *variable, 0);
        Array3f ratio = dataset.read(variable->name, time, {}, partOf(progress, part++, parts));
        const Repairs repairs = repair(ratio);
        std::ranges::move(describe(repairs, variable->name), std::back_inserter(volume.notes));
        if (repairs.allZero) empty.push_back(variable->name);
        volume.contentKgPerM3[static_cast<std::size_t>(*variable->species)] =
            remap(heights, density, ratio, volume.grid, partOf(progress, part++, parts));
    }
    if (ratios.empty()) {
        volume.notes.push_back("This file has no hydrometeors (QCLOUD, QICE, QRAIN, ...).");
    } else if (empty.size() == ratios.size()) {
        volume.notes.push_back(fmt::format(
            "There is no condensate at {}: every mixing ratio is zero.", volume.timeLabel));
    } else {
        for (const std::string& name : empty) {
            volume.notes.push_back(fmt::format("{}: zero everywhere at this time.", name));
        }
    }
    return volume;
}

}  // namespace neph
