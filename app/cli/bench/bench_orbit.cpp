// bench_orbit.cpp: turns of rows of orbiting frames, and what is made of their times.
#include "app/cli/bench/bench_orbit.h"

#include <algorithm>

namespace neph::bench {
namespace {

constexpr double kFloorBytes = 8.0 * 8.0;  // of the texels of a trilinear fetch, RGBA16

double azimuthOf(const BenchRequest& request, double frame) {
    return 360.0 * frame / request.frames;
}

void push(std::vector<double>& values, std::optional<double> value) {
    if (value) values.push_back(*value);
}

/// One turn; `frame` counts from 0, negative ones warm up.
void takeTurn(const Run& run, const OrbitPlan& plan, render::Renderer& renderer, int frame,
              Row& row) {
    const auto inputsAt = [&](double turn) {
        render::FrameInputs inputs =
            run.inputs(plan.grid, plan.sizePx, azimuthOf(run.request, frame + turn));
        setMode(inputs.look, *row.mode, row.engine);
        inputs.planes = plan.steps;
        return inputs;
    };
    renderer.render(inputsAt(-0.5));
    const render::FrameStats stats = renderer.render(inputsAt(0.0));
    render::FrameInputs profiled = inputsAt(0.5);
    profiled.profile = true;
    const render::FrameStats profile = renderer.render(profiled);
    const std::optional<double> floorMs = renderer.floorMilliseconds();
    if (frame < 0) return;
    row.frameMs.push_back(stats.milliseconds);
    if (stats.bakedMedium || stats.marchedLight) ++row.framesWithLight;
    push(row.eyeMs, eyeMilliseconds(profile));
    push(row.floorMs, floorMs);
    row.bytesPerSample = profile.bytesPerSample;
    if (!profile.samples || profile.samples->taken == 0) return;
    row.samples.push_back(static_cast<double>(profile.samples->taken));
    row.rays.push_back(static_cast<double>(profile.samples->rays));
}

}  // namespace

RegularGrid upload(const SpeciesVolume& volume, const GridRequest& request,
                   render::Renderer& renderer) {
    const SpeciesVolume finer = onGrid(volume, request);
    renderer.setVolume(finer);
    return finer.grid;
}

void orbitAll(const Run& run, const OrbitPlan& plan, render::Renderer& renderer,
              std::span<Row> rows) {
    for (int frame = -kWarmUp; frame < run.request.frames; ++frame) {
        for (Row& row : rows) takeTurn(run, plan, renderer, frame, row);
    }
}

Json Row::toJson() const {
    const auto median = [](const std::vector<double>& values) {
        return values.empty() ? Json() : Json(medianOf(values));
    };
    const auto ratio = [](const Json& a, double factor, const Json& b) {
        return a.is_number() && b.is_number() ? Json(a.get<double>() * factor / b.get<double>())
                                              : Json();
    };
    Json json = timesOf(frameMs);
    json["frames"] = frameMs.size();
    json["frames_with_light"] = framesWithLight;
    json["eye_ms"] = median(eyeMs);
    json["floor_ms"] = median(floorMs);
    json["eye_to_floor"] = ratio(json["eye_ms"], 1.0, json["floor_ms"]);
    json["samples"] = median(samples);
    json["samples_per_ray"] = ratio(json["samples"], 1.0, median(rays));
    json["bytes_per_sample"] = bytesPerSample;
    // bytes a millisecond are 1e-6 GB/s
    json["eye_gb_per_s"] = ratio(json["samples"], bytesPerSample * 1e-6, json["eye_ms"]);
    json["floor_gb_per_s"] = ratio(json["samples"], kFloorBytes * 1e-6, json["floor_ms"]);
    return json;
}

}  // namespace neph::bench
