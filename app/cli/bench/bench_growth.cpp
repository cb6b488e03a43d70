// bench_growth.cpp: the same storm on grids of twice the cells in each direction.
//
// Steps double with the cells, so that every voxel on a ray is sampled as before.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "app/cli/bench/bench_orbit.h"
#include "app/cli/bench/bench_sections.h"
#include "core/base/resources.h"

namespace neph::bench {
namespace {

constexpr glm::ivec2 kSizePx{300};  // as the modes
constexpr int kMaxSteps = 4096;

int longestOf(glm::ivec3 size) {
    return std::max({size.x, size.y, size.z});
}

/// Of an image with noise, which holds all that any mode needs.
Json memoryOf(const Run& run, const OrbitPlan& plan, render::Renderer& renderer, Engine engine) {
    render::FrameInputs inputs = run.inputs(plan.grid, plan.sizePx, 0.0);
    setMode(inputs.look, kModes.back(), engine);
    inputs.planes = plan.steps;
    renderer.render(inputs);
    Json parts;
    std::size_t growing = 0;
    for (const render::MemoryUse& part : renderer.memory()) {
        parts[std::string(part.name)] = part.bytes;
        if (part.ofVoxels) growing += part.bytes;
    }
    const auto voxels = static_cast<double>(plan.grid.cellCount());
    return {{"gpu_bytes", parts}, {"gpu_bytes_per_voxel", static_cast<double>(growing) / voxels}};
}

Json ratio(const Json& row, const Json* before) {
    if (!before || !row["eye_ms"].is_number()) return {};
    return row["eye_ms"].get<double>() / (*before)["eye_ms"].get<double>();
}

void print(const Json& row) {
    fmt::print(stderr, "{:<16} {:<28} {:>6} {:>8} {:>8} {:>6} {:>8} {:>8}\n",
               textOf(glm::ivec3(row["grid"][0], row["grid"][1], row["grid"][2])),
               row["mode"].get<std::string>(), row["steps"].get<int>(), cell(row["median_ms"]),
               cell(row["eye_ms"]), cell(row["ratio_to_grid_before"], 2), cell(row["floor_ms"]),
               cell(row["gpu_bytes_per_voxel"], 1));
}

/// Adds a row for each mode and returns the grid.
RegularGrid measureGrid(const Run& run, const GridRequest& request, int steps, Json& rows) {
    render::Renderer renderer(resourcePath("shaders"));
    const RegularGrid grid = upload(run.volume, request, renderer);
    const OrbitPlan plan{grid, run.sizesOr(kSizePx).front(), steps};
    const Engine engine = run.request.engines.front();
    const Json memory = memoryOf(run, plan, renderer, engine);
    std::vector<Row> orbits;
    for (const Mode& mode : kModes) orbits.push_back({engine, &mode});
    orbitAll(run, plan, renderer, orbits);
    for (const Row& orbit : orbits) {
        const bool first = rows.size() < kModes.size();
        const Json before = first ? Json() : rows[rows.size() - kModes.size()];
        Json row{{"engine", traitsOf(engine).id},
                 {"mode", orbit.mode->id},
                 {"grid", toJson(grid.size)},
                 {"size", toJson(plan.sizePx)},
                 {"steps", steps}};
        row.update(orbit.toJson());
        row["ratio_to_grid_before"] = ratio(row, first ? nullptr : &before);
        row.update(memory);
        print(row);
        rows.push_back(std::move(row));
    }
    return grid;
}

}  // namespace

Json measureGrowth(const Run& run) {
    fmt::print(stderr, "\ngrowth: as many steps per voxel on every grid\n");
    fmt::print(stderr, "{:<16} {:<28} {:>6} {:>8} {:>8} {:>6} {:>8} {:>8}\n", "cells", "mode",
               "steps", "median", "eye ms", "ratio", "floor", "B/voxel");
    Json rows = Json::array();
    int steps = run.request.steps;
    glm::ivec3 size = measureGrid(run, run.request.grids.front(), steps, rows).size;
    while (2 * longestOf(size) <= run.request.growthTo && 2 * steps <= kMaxSteps) {
        size *= 2;
        steps *= 2;
        measureGrid(run, {0, size}, steps, rows);
    }
    return {{"floor", kFloorText},
            {"bytes_per_voxel", "species, medium and light; images and noise do not grow"},
            {"rows", rows}};
}

}  // namespace neph::bench
