// bench_command.cpp: opening data up to the first image, then the sections asked for.
#include "app/cli/bench/bench_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <thread>
#include <utility>

#include "app/cli/bench/bench_sections.h"
#include "app/cli/common/scene.h"
#include "app/gl/context.h"
#include "app/render/renderer.h"
#include "core/base/atomic_file.h"
#include "core/base/resources.h"
#include "core/dataset/file_list.h"
#include "core/dataset/whereabouts.h"
#include "core/look/haze.h"
#include "core/look/old_metres.h"
#include "core/plugin/plugin_host.h"
#include "core/volume/framing.h"
#include "core/volume/lowest_air.h"
#include "core/volume/memory_setting.h"
#include "core/volume/nested_volume.h"
#include "core/volume/read_plan.h"

namespace neph {
namespace {

using bench::Json;
using Clock = std::chrono::steady_clock;

constexpr int kBenchTime = 1;  // of the bundled storm: 01:00, the storm begins to split
constexpr glm::ivec2 kFirstImagePx{300};

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

double mebibytes(std::uint64_t bytes) {
    return static_cast<double>(bytes) / 1048576.0;
}

struct Opened {
    std::shared_ptr<Dataset> dataset;
    int time = 0;
    NestedPlan plan;
    RadiusPlan radii;
    SpeciesVolume volume;
    double openMs = 0.0, planMs = 0.0, resampleMs = 0.0;
    std::uint64_t peakBytes = 0;  ///< resident while reading, above what there was before
};

Opened openData(const bench::BenchRequest& request, const Look& look, std::uint64_t gpuBytes) {
    Opened opened;
    resetPeak();
    const std::uint64_t before = processBytes("VmRSS");
    const auto start = Clock::now();
    opened.dataset = Dataset::open(listFiles(request.scene.files),
                                   PluginHost::standard(request.scene.readers, request.scene.map));
    opened.openMs = millisecondsSince(start);
    const int last = static_cast<int>(opened.dataset->info().times.size()) - 1;
    opened.time = std::min(kBenchTime, last);
    const auto planning = Clock::now();
    opened.plan = planNested(*opened.dataset, opened.time, {}, memoryBudget("", gpuBytes));
    opened.planMs = millisecondsSince(planning);
    opened.radii = planRadii(look, opened.dataset->info());
    const auto begun = Clock::now();
    opened.volume = readNested(*opened.dataset, opened.time, opened.plan, opened.radii);
    opened.resampleMs = millisecondsSince(begun);
    opened.peakBytes = processBytes("VmHWM") - std::min(before, processBytes("VmHWM"));
    return opened;
}

/// The time beside the one that was opened, where there is one.
std::optional<SpeciesVolume> readOtherTime(const Opened& opened) {
    const int last = static_cast<int>(opened.dataset->info().times.size()) - 1;
    if (last == 0) return {};
    const int other = opened.time < last ? opened.time + 1 : opened.time - 1;
    if (opened.dataset->nests().empty()) {
        return readNested(*opened.dataset, other, opened.plan, opened.radii);
    }
    const NestedPlan plan =
        planNested(*opened.dataset, other, {},
                   {.machine = opened.plan.shown.machineBytes, .gpu = opened.plan.shown.gpuBytes});
    return readNested(*opened.dataset, other, plan, opened.radii);
}

Json summaryOf(const Opened& opened, double firstImageMs, std::uint64_t gpuBytes) {
    const ReadPlan& plan = opened.plan.shown;
    const glm::ivec3 size = opened.volume.grid.size;
    return {{"open_ms", opened.openMs},
            {"plan_ms", opened.planMs},
            {"resample_ms", opened.resampleMs},
            {"first_image_ms", firstImageMs},
            {"times", opened.dataset->info().times.size()},
            {"time", opened.volume.timeLabel},
            {"grid", bench::toJson(size)},
            {"coarsening", plan.coarsening},
            {"plan", describe(plan, opened.dataset->info())},
            {"fields_bytes", plan.machineBytes},
            {"gpu_bytes", gpuBytes},
            {"peak_resident_bytes_reading", opened.peakBytes},
            {"peak_resident_bytes", processBytes("VmHWM")}};
}

/// The bundled storm is seen as the standard preset has it, so that figures of all versions can be
/// compared; other data are seen whole unless a camera was asked for.
CameraPose poseFor(const bench::BenchRequest& request, const Scene& scene,
                   const SpeciesVolume& volume) {
    const CameraPose& pose = scene.document.camera;
    if (request.scene.files.empty() || scene.cameraAsked) return pose;
    return framed(View::fit, pose, summarise(volume), scene.document.look, 1.0);
}

/// Opens the data and draws them once; the scene's camera becomes the one they are seen by.
std::pair<Opened, Json> measureOpening(const bench::BenchRequest& request, Scene& scene,
                                       Clock::time_point start) {
    render::Renderer renderer(resourcePath("shaders"));
    Opened opened = openData(request, scene.document.look, rendererBytes(gl::deviceMemory()));
    renderer.setVolume(opened.volume);
    scene.document.camera = poseFor(request, scene, opened.volume);
    Look& look = scene.document.look;
    Whereabouts where = whereaboutsOf(opened.dataset->info(), opened.time, opened.volume.grid);
    if (asksHumidity(look)) {
        const LowestAir air = readLowestAir(*opened.dataset, opened.time);
        where.humidity = air.humidity;
        where.aerosolPerM = air.aerosolPerM;
    }
    look = lookAsDrawn(look, where);
    render::FrameInputs inputs;
    static_cast<ParameterSet&>(inputs) = scene.document;
    inputs.sizePx = kFirstImagePx;
    inputs.camera = placeCamera(scene.document.camera, opened.volume.grid, 1.0);
    inputs.settledLight = false;  // as in the window, where it comes by itself
    renderer.render(inputs);
    Json summary = summaryOf(opened, millisecondsSince(start), renderer.gpuBytes());
    fmt::print(stderr, "{}\nopen {:.0f} ms, resample {:.0f} ms, first image after {:.0f} ms\n",
               renderer.deviceName(), opened.openMs, opened.resampleMs,
               summary["first_image_ms"].get<double>());
    fmt::print(stderr, "fields {:.1f} MiB, on the GPU {:.1f} MiB, peak resident {:.1f} MiB\n",
               mebibytes(opened.plan.shown.machineBytes), mebibytes(renderer.gpuBytes()),
               mebibytes(processBytes("VmHWM")));
    Json result{{"renderer", renderer.deviceName()},
                {"version", versionText()},
                {"threads", std::thread::hardware_concurrency()},
                {"opening", std::move(summary)}};
    return {std::move(opened), std::move(result)};
}

void measureSections(const bench::Run& run, Json& result) {
    using Measure = Json (*)(const bench::Run&);
    // In the order of bench::Section.
    constexpr std::array<Measure, bench::kSectionNames.size()> kMeasures{
        bench::measureModes, bench::measureChanges, bench::measureGrowth, bench::measureWindow,
        bench::measureReference};
    const std::vector<bench::Section>& wanted = run.request.sections;
    for (std::size_t i = 0; i < kMeasures.size(); ++i) {
        if (std::ranges::find(wanted, static_cast<bench::Section>(i)) == wanted.end()) continue;
        result[std::string(bench::kSectionNames[i])] = kMeasures[i](run);
    }
}

void write(const bench::BenchRequest& request, const Json& result) {
    const std::string text = result.dump(2) + "\n";
    if (request.json.empty()) {
        fmt::print("{}", text);
    } else {
        replaceFile(request.json, text);
    }
}

}  // namespace

int runBench(const bench::BenchRequest& request) {
    if (!request.json.empty()) checkReplaceable(request.json);
    const auto start = Clock::now();
    Scene scene = makeScene(request.scene);
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "warning: {}\n", warning);
    const gl::HeadlessContext context;
    auto [opened, result] = measureOpening(request, scene, start);
    const std::string note = bringToCells(scene.document.look, std::exchange(scene.inMetres, 0),
                                          opened.dataset->finestCellM());
    if (!note.empty()) fmt::print(stderr, "note: {}\n", note);
    bench::Run run{request, scene.document, scene.document.camera, {}, {}};
    if (!request.openOnly) {
        run.otherTime = readOtherTime(opened);
        run.volume = std::move(opened.volume);
        measureSections(run, result);
    }
    write(request, result);
    return 0;
}

}  // namespace neph
