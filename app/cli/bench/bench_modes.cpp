// bench_modes.cpp: orbiting frames in [Riley03] table 4's modes, and with full transport, beside
// the floor.
//
// All rows take turns, so that other work on the machine slows down all alike.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "app/cli/bench/bench_orbit.h"
#include "app/cli/bench/bench_sections.h"
#include "core/base/resources.h"

namespace neph::bench {
namespace {

constexpr glm::ivec2 kSizePx{300};  // [Riley03] §5

Json rowJson(const Row& row, const OrbitPlan& plan, const Row& simplest) {
    Json json{{"engine", traitsOf(row.engine).id},
              {"mode", row.mode->id},
              {"grid", toJson(plan.grid.size)},
              {"size", toJson(plan.sizePx)},
              {"steps", plan.steps}};
    json.update(row.toJson());
    const double median = medianOf(row.frameMs);
    json["fps"] = 1000.0 / median;
    json["ratio_to_simplest"] = median / medianOf(simplest.frameMs);
    json["paper_fps"] = row.mode->paperFps > 0.0 ? Json(row.mode->paperFps) : Json();
    return json;
}

void print(const Json& json) {
    fmt::print(stderr, "{:<8} {:<28} {:>8} {:>8} {:>8} {:>7} {:>6} {:>7} {:>7} {:>6} {:>7} {:>6}\n",
               json["engine"].get<std::string>(), json["mode"].get<std::string>(),
               cell(json["median_ms"]), cell(json["min_ms"]), cell(json["max_ms"]),
               cell(json["fps"]), cell(json["ratio_to_simplest"], 2), cell(json["eye_ms"]),
               cell(json["floor_ms"]), cell(json["eye_to_floor"], 2), cell(json["eye_gb_per_s"]),
               cell(json["paper_fps"], 2));
}

void measureSize(const Run& run, const OrbitPlan& plan, render::Renderer& renderer, Json& rows) {
    std::vector<Row> orbits;
    for (const Engine engine : run.request.engines) {
        for (const Mode& mode : kModes) orbits.push_back({engine, &mode});
        if (traitsOf(engine).scattersOften) orbits.push_back({engine, &kFullMode});
    }
    orbitAll(run, plan, renderer, orbits);
    fmt::print(stderr, "\nmodes: {} pixels, {} steps, {} cells\n", textOf(plan.sizePx), plan.steps,
               textOf(plan.grid.size));
    fmt::print(stderr, "{:<8} {:<28} {:>8} {:>8} {:>8} {:>7} {:>6} {:>7} {:>7} {:>6} {:>7} {:>6}\n",
               "engine", "mode", "median", "min", "max", "fps", "ratio", "eye ms", "floor", "ratio",
               "GB/s", "paper");
    for (const Row& row : orbits) {
        const Row& simplest = *std::ranges::find(orbits, row.engine, &Row::engine);
        rows.push_back(rowJson(row, plan, simplest));
        print(rows.back());
    }
}

}  // namespace

Json measureModes(const Run& run) {
    Json rows = Json::array();
    for (const GridRequest& request : run.request.grids) {
        render::Renderer renderer(resourcePath("shaders"));
        const RegularGrid grid = upload(run.volume, request, renderer);
        for (const glm::ivec2 sizePx : run.sizesOr(kSizePx)) {
            measureSize(run, {grid, sizePx, run.request.steps}, renderer, rows);
        }
    }
    return {{"floor", kFloorText}, {"bandwidth", kBandwidthText}, {"rows", rows}};
}

}  // namespace neph::bench
