// bench_run.cpp: grids, cameras and medians of the sections of `bench`.
#include "app/cli/bench/bench_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/volume/upsample.h"

namespace neph::bench {

void setMode(Look& look, const Mode& mode, Engine engine) {
    look.transport = mode.transport;
    look.phaseMode = mode.phase;
    look.noise = mode.noise;
    look.engine = engine;
}

std::vector<Engine> measuredEngines() {
    std::vector<Engine> engines;
    for (const EngineTraits& engine : kEngines) {
        if (engine.refinement != Refinement::converges) engines.push_back(engine.engine);
    }
    return engines;
}

std::vector<glm::ivec2> Run::sizesOr(glm::ivec2 own) const {
    return request.sizesPx.empty() ? std::vector{own} : request.sizesPx;
}

render::FrameInputs Run::inputs(const RegularGrid& grid, glm::ivec2 sizePx, double turnDeg) const {
    CameraPose turned = pose;
    orbit(turned, static_cast<float>(turnDeg), 0.0f);
    render::FrameInputs inputs;
    static_cast<ParameterSet&>(inputs) = parameters;
    inputs.sizePx = sizePx;
    inputs.camera = placeCamera(turned, grid, static_cast<double>(sizePx.x) / sizePx.y);
    return inputs;
}

glm::ivec3 sizeOn(const GridRequest& request, glm::ivec3 own) {
    if (request.longest == 0) return glm::max(request.size, own);
    const double factor = static_cast<double>(request.longest) / std::max({own.x, own.y, own.z});
    return glm::max(glm::ivec3(glm::round(glm::dvec3(own) * factor)), own);
}

SpeciesVolume onGrid(const SpeciesVolume& volume, const GridRequest& request) {
    SpeciesVolume finer = volume;
    upsample(finer, sizeOn(request, volume.grid.size));
    return finer;
}

double medianOf(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return (values[half] + values[values.size() - 1 - half]) / 2.0;
}

Json timesOf(std::span<const double> milliseconds) {
    const auto [least, most] = std::minmax_element(milliseconds.begin(), milliseconds.end());
    return {{"median_ms", medianOf({milliseconds.begin(), milliseconds.end()})},
            {"min_ms", *least},
            {"max_ms", *most}};
}

Json toJson(glm::ivec2 size) {
    return {size.x, size.y};
}

Json toJson(glm::ivec3 size) {
    return {size.x, size.y, size.z};
}

std::string textOf(glm::ivec2 size) {
    return fmt::format("{} x {}", size.x, size.y);
}

std::string textOf(glm::ivec3 size) {
    return fmt::format("{} x {} x {}", size.x, size.y, size.z);
}

std::string cell(const Json& number, int decimals) {
    return number.is_number() ? fmt::format("{:.{}f}", number.get<double>(), decimals) : "-";
}

std::optional<double> eyeMilliseconds(const render::FrameStats& stats) {
    for (const render::PassTime& pass : stats.passes) {
        if (pass.name == render::kEyePass) return pass.milliseconds;
    }
    return {};
}

}  // namespace neph::bench
