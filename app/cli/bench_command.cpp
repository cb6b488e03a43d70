// bench_command.cpp: [Riley03] table 4 on this machine: 300 x 300 pixels, 128 planes, four modes.
//
// The camera goes round the storm, a new azimuth every frame, so that nothing of the last frame can
// be shown again. Times are wall time of one frame with the GPU finished.
#include "app/cli/bench_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/gl/context.h"
#include "app/render/renderer.h"
#include "app/scene.h"
#include "core/atomic_file.h"
#include "core/file_list.h"
#include "core/memory_setting.h"
#include "core/plugin_host.h"
#include "core/read_plan.h"
#include "core/resample.h"
#include "core/resources.h"

namespace neph {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kSidePx = 300;   // [Riley03] §5
constexpr int kPlanes = 128;   // [Riley03] §5
constexpr int kWarmUp = 2;     // the first frames fill caches
constexpr int kFrames = 12;    // measured a mode; 30 degrees apart once round
constexpr int kBenchTime = 1;  // of the bundled storm: 01:00, the storm begins to split

struct Mode {
    std::string_view id;
    Transport transport;
    PhaseMode phase;
    bool noise;
    double paperFps;  // [Riley03] table 4
};
constexpr std::array kModes{
    Mode{"uniform-low-albedo", Transport::lowAlbedo, PhaseMode::uniform, false, 5.1},
    Mode{"uniform-translucent", Transport::translucent, PhaseMode::uniform, false, 4.28},
    Mode{"per-field-translucent", Transport::translucent, PhaseMode::perField, false, 1.68},
    Mode{"per-field-noise-translucent", Transport::translucent, PhaseMode::perField, true, 1.18},
};

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A figure of /proc/self/status, bytes; 0 where there is none.
std::uint64_t processBytes(std::string_view key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(key)) return std::stoull(line.substr(key.size() + 1)) * 1024;
    }
    return 0;
}

/// Makes the peak start again from what is resident now, proc(5).
void resetPeak() {
    std::ofstream("/proc/self/clear_refs") << 5;
}

render::FrameInputs inputsOf(const Mode& mode, const Scene& scene, const RegularGrid& grid,
                             int frame) {
    render::FrameInputs inputs;
    inputs.look = scene.document.look;
    inputs.look.transport = mode.transport;
    inputs.look.phaseMode = mode.phase;
    inputs.look.noise = mode.noise;
    inputs.sizePx = {kSidePx, kSidePx};
    inputs.planes = kPlanes;
    CameraPose pose = scene.document.camera;
    orbit(pose, 360.0f * static_cast<float>(frame) / static_cast<float>(kFrames), 0.0f);
    inputs.camera = placeCamera(pose, grid, 1.0);
    return inputs;
}

nlohmann::ordered_json measure(const Mode& mode, const Scene& scene, const RegularGrid& grid,
                               render::Renderer& renderer) {
    std::vector<double> milliseconds;
    for (int frame = -kWarmUp; frame < kFrames; ++frame) {
        const render::FrameInputs inputs = inputsOf(mode, scene, grid, frame);
        const auto start = Clock::now();
        renderer.render(inputs);
        if (frame >= 0) milliseconds.push_back(millisecondsSince(start));
    }
    std::sort(milliseconds.begin(), milliseconds.end());
    const std::size_t half = milliseconds.size() / 2;
    const double median = (milliseconds[half] + milliseconds[milliseconds.size() - 1 - half]) / 2.0;
    fmt::print(stderr, "{:<28} {:>8.1f} {:>8.1f} {:>8.1f} {:>7.2f} {:>7.2f}\n", mode.id, median,
               milliseconds.front(), milliseconds.back(), 1000.0 / median, mode.paperFps);
    return {{"engine", "slicing"},
            {"mode", mode.id},
            {"frames", kFrames},
            {"median_ms", median},
            {"min_ms", milliseconds.front()},
            {"max_ms", milliseconds.back()},
            {"fps", 1000.0 / median},
            {"paper_fps", mode.paperFps}};
}

struct Opened {
    std::shared_ptr<Dataset> dataset;
    ReadPlan plan;
    SpeciesVolume volume;
    double openMs = 0.0, planMs = 0.0, resampleMs = 0.0;
    std::uint64_t peakBytes = 0;  ///< resident while reading, above what there was before
};

Opened openData(const BenchOptions& options, std::uint64_t gpuBytes) {
    Opened opened;
    resetPeak();
    const std::uint64_t before = processBytes("VmRSS");
    const auto start = Clock::now();
    opened.dataset = Dataset::open(listFiles(options.files), PluginHost::standard(options.readers));
    opened.openMs = millisecondsSince(start);
    const int last = static_cast<int>(opened.dataset->info().times.size()) - 1;
    const int time = std::min(kBenchTime, last);
    const auto planning = Clock::now();
    opened.plan = planRead(*opened.dataset, time, {}, memoryBudget("", gpuBytes));
    opened.planMs = millisecondsSince(planning);
    const auto begun = Clock::now();
    opened.volume = resample(*opened.dataset, time, {opened.plan});
    opened.resampleMs = millisecondsSince(begun);
    opened.peakBytes = processBytes("VmHWM") - std::min(before, processBytes("VmHWM"));
    return opened;
}

nlohmann::ordered_json summaryOf(const Opened& opened, double firstPictureMs) {
    const ReadPlan& plan = opened.plan;
    return {{"open_ms", opened.openMs},
            {"plan_ms", opened.planMs},
            {"resample_ms", opened.resampleMs},
            {"first_picture_ms", firstPictureMs},
            {"times", opened.dataset->info().times.size()},
            {"coarsening", plan.coarsening},
            {"plan", describe(plan, opened.dataset->info())},
            {"fields_bytes", plan.machineBytes},
            {"peak_resident_bytes", opened.peakBytes}};
}

void measureModes(const Scene& scene, const RegularGrid& grid, render::Renderer& renderer,
                  nlohmann::ordered_json& result) {
    fmt::print(stderr, "{:<28} {:>8} {:>8} {:>8} {:>7} {:>7}\n", "mode", "median", "min", "max",
               "fps", "paper");
    for (const Mode& mode : kModes) {
        result["rows"].push_back(measure(mode, scene, grid, renderer));
    }
}

double mebibytes(std::uint64_t bytes) {
    return static_cast<double>(bytes) / 1048576.0;
}

void write(const BenchOptions& options, const nlohmann::ordered_json& result) {
    const std::string text = result.dump(2) + "\n";
    if (options.json.empty()) {
        fmt::print("{}", text);
    } else {
        replaceFile(options.json, text);
    }
}

}  // namespace

int runBench(const BenchOptions& options) {
    if (!options.json.empty()) checkReplaceable(options.json);
    const auto start = Clock::now();
    const Scene scene = makeScene({});
    const gl::HeadlessContext context;
    render::Renderer renderer(resourcePath("shaders"));
    Opened opened = openData(options, rendererBytes(gl::deviceMemory()));
    renderer.setVolume(opened.volume);
    const RegularGrid grid = opened.volume.grid;
    const std::string time = opened.volume.timeLabel;
    opened.volume = {};
    renderer.render(inputsOf(kModes[2], scene, grid, 0));
    const double firstPictureMs = millisecondsSince(start);

    nlohmann::ordered_json result{{"renderer", renderer.deviceName()},
                                  {"version", versionText()},
                                  {"size", {kSidePx, kSidePx}},
                                  {"planes", kPlanes},
                                  {"time", time},
                                  {"grid", {grid.size.x, grid.size.y, grid.size.z}},
                                  {"opening", summaryOf(opened, firstPictureMs)}};
    fmt::print(stderr, "{}\nopen {:.0f} ms, resample {:.0f} ms, first picture after {:.0f} ms\n",
               renderer.deviceName(), opened.openMs, opened.resampleMs, firstPictureMs);
    if (!options.openOnly) measureModes(scene, grid, renderer, result);
    result["memory"] = {{"gpu_bytes", renderer.gpuBytes()},
                        {"peak_resident_bytes", processBytes("VmHWM")}};
    fmt::print(stderr, "fields {:.1f} MiB, on the GPU {:.1f} MiB, peak resident {:.1f} MiB\n",
               mebibytes(opened.plan.machineBytes), mebibytes(renderer.gpuBytes()),
               mebibytes(processBytes("VmHWM")));
    write(options, result);
    return 0;
}

}  // namespace neph
