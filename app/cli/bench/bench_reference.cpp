// bench_reference.cpp: paths, places and scatterings per second of the reference, and how long an
// error would take.
//
// The first pass, which compiles shaders and prepares the medium, is left out of the rates.
#include <fmt/format.h>

#include <cstdio>

#include "app/cli/bench/bench_sections.h"
#include "core/base/resources.h"

namespace neph::bench {
namespace {

constexpr glm::ivec2 kSizePx{160, 90};
constexpr double kTargetError = 0.02;  // of figures that are told for a GPU

Json measureSize(const Run& run, glm::ivec2 sizePx) {
    render::Renderer renderer(resourcePath("shaders"));
    renderer.setVolume(run.volume);
    render::FrameInputs inputs = run.inputs(run.volume.grid, sizePx, 0.0);
    inputs.look.engine = groundTruth();
    render::Accumulation image;
    const ReferenceProgress first = renderer.render(inputs, image).reference;
    ReferenceProgress last;
    while (image.samples() <= run.request.frames) last = renderer.render(inputs, image).reference;
    const double seconds = last.seconds - first.seconds;
    const double paths = static_cast<double>(sizePx.x) * sizePx.y * (last.samples - first.samples);
    const auto collisions = static_cast<double>(last.collisions - first.collisions);
    const auto scatterings = static_cast<double>(last.scatterings - first.scatterings);
    const double toTarget = last.seconds * workTo(kTargetError, last);
    fmt::print(stderr, "{:<12} {:>6} {:>10.0f} {:>12.2f} {:>12.1f} {:>10.1f} {:>10.0f}\n",
               textOf(sizePx), last.samples, paths / seconds, 1e-6 * collisions / seconds,
               scatterings / paths, 100.0 * last.relativeError, toTarget);
    return {{"size", toJson(sizePx)},
            {"grid", toJson(run.volume.grid.size)},
            {"samples", last.samples},
            {"seconds", seconds},
            {"paths_per_s", paths / seconds},
            {"collisions_per_s", collisions / seconds},
            {"collisions_per_path", collisions / paths},
            {"scatterings_per_path", scatterings / paths},
            {"relative_error", last.relativeError},
            {"seconds_to_2_percent", toTarget}};
}

}  // namespace

Json measureReference(const Run& run) {
    fmt::print(stderr, "\nreference: {} passes after the first\n", run.request.frames);
    fmt::print(stderr, "{:<12} {:>6} {:>10} {:>12} {:>12} {:>10} {:>10}\n", "size", "samples",
               "paths/s", "Mcollisions/s", "scatt./path", "error %", "s to 2 %");
    Json rows = Json::array();
    for (const glm::ivec2 size : run.sizesOr(kSizePx)) rows.push_back(measureSize(run, size));
    return {{"collisions", "collisions, real and null, by the bound"},
            {"relative_error", "root mean variance of the pixels' means over the image's mean"},
            {"rows", rows}};
}

}  // namespace neph::bench
