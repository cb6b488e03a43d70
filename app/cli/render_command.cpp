// render_command.cpp: opens, resamples, renders and writes, one time after the other.
#include "app/cli/render_command.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <set>

#include "app/gl/context.h"
#include "app/image_io/exr.h"
#include "app/image_io/png.h"
#include "app/render/renderer.h"
#include "core/atomic_file.h"
#include "core/file_list.h"
#include "core/held_volume.h"
#include "core/plugin_host.h"
#include "core/preset.h"
#include "core/resources.h"

namespace neph {
namespace {

// Largest picture a side: what every OpenGL 4.5 driver takes as a texture.
constexpr int kMaxSidePx = 16384;

enum class FileKind { png, exr };

FileKind kindOf(const std::filesystem::path& out) {
    const std::string extension = out.extension().string();
    if (extension == ".png") return FileKind::png;
    if (extension == ".exr") return FileKind::exr;
    throw UsageError({"--out " + out.string(), "the kind of file is not known",
                      extension.empty() ? "no extension" : extension, ".png or .exr", ""});
}

void checkOptions(const RenderOptions& options) {
    kindOf(options.out);
    if (options.engine != "slicing") {
        throw UsageError({"--engine", "there is no engine " + options.engine, "", "slicing", ""});
    }
    if (options.format != "half" && options.format != "float") {
        throw UsageError({"--format", "is not known", options.format, "half or float", ""});
    }
    parseSize(options.size);
    checkReplaceable(options.out);  // now rather than after the work
}

/// As part of the look, so that the look in the metadata renders the same picture again.
void applyPlanes(const RenderOptions& options, Look& look) {
    if (!options.planes) return;
    try {
        setValue(look, parameter("view.planes"), *options.planes);
    } catch (const Error& error) {
        ErrorParts parts = error.parts();
        parts.where = "--planes";
        throw UsageError(parts);
    }
}

/// What all times of one command share.
struct Run {
    const RenderOptions& options;
    const Scene& scene;
    Dataset& dataset;
    const VolumeRequest& request;
    render::Renderer& renderer;
    std::set<std::string> said{};  ///< notes: what holds for all times is told once

    const DatasetInfo& info() const { return dataset.info(); }
};

Metadata describe(const Run& run, const HeldVolume& held, const TimeInfo& time,
                  const render::FrameStats& stats) {
    const Scene& scene = run.scene;
    const std::string plan = neph::describe(held.summary.plan, run.info());
    const CameraPose& pose = scene.document.camera;
    const Preset preset{scene.presetName, "", scene.document.look, pose};
    return {
        {"Software", fmt::format("Nephoscope {}", versionText())},
        {"nephoscope.preset", scene.presetName},
        {"nephoscope.camera",
         fmt::format("target {},{},{} distance {} azimuth {} elevation {} fov {}", pose.target.x,
                     pose.target.y, pose.target.z, pose.distance, pose.azimuthDeg,
                     pose.elevationDeg, pose.fovDeg)},
        {"nephoscope.look", formatPreset(preset)},
        {"nephoscope.data",
         fmt::format("{}; {}; file {}; time {}; reader {}", run.info().model, run.info().scheme,
                     time.file.filename().string(), held.volume.timeLabel, run.info().reader)},
        {"nephoscope.resolution", plan.empty() ? "full" : plan},
        {"nephoscope.renderer", fmt::format("{} engine, {} planes, {}", run.options.engine,
                                            stats.planes, run.renderer.deviceName())},
    };
}

void write(const RenderOptions& options, const std::filesystem::path& out,
           const render::Renderer& renderer, const Metadata& metadata) {
    if (kindOf(out) == FileKind::png) {
        writePng(out, renderer.readDisplay(), metadata);
    } else {
        writeExr(out, renderer.readLinear(), metadata,
                 options.format == "float" ? ExrPixels::full : ExrPixels::half);
    }
}

void printAll(std::string_view kind, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) fmt::print(stderr, "{}: {}\n", kind, line);
}

void sayOnce(Run& run, const std::string& note) {
    if (!note.empty() && run.said.insert(note).second) printAll("note", {note});
}

/// One time: read, render, write, and say so.
void renderTime(Run& run, int time, bool several) {
    const HeldVolume held = readVolume(run.dataset, time, run.request);
    for (const std::string& note : held.volume.notes) sayOnce(run, note);
    sayOnce(run, neph::describe(held.summary.plan, run.info()));
    run.renderer.setVolume(held.volume);
    render::FrameInputs inputs;
    inputs.look = run.scene.document.look;
    inputs.sizePx = parseSize(run.options.size);
    inputs.camera = placeCamera(run.scene.document.camera, held.volume.grid,
                                static_cast<double>(inputs.sizePx.x) / inputs.sizePx.y);
    const render::FrameStats stats = run.renderer.render(inputs);
    printAll("warning", run.renderer.takeMessages());
    const TimeInfo& info = run.info().times[static_cast<std::size_t>(time)];
    const auto out = outputName(run.options.out, time, several);
    write(run.options, out, run.renderer, describe(run, held, info, stats));
    fmt::print(stderr, "wrote {} ({}x{}, {}, {} planes, {:.0f} ms)\n", out.string(),
               inputs.sizePx.x, inputs.sizePx.y, held.volume.timeLabel, stats.planes,
               stats.milliseconds);
}

}  // namespace

glm::ivec2 parseSize(const std::string& text) {
    glm::ivec2 size{0};
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.x);
    if (width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.y);
        const bool fits =
            size.x >= 1 && size.y >= 1 && size.x <= kMaxSidePx && size.y <= kMaxSidePx;
        if (height.ec == std::errc{} && height.ptr == end && fits) return size;
    }
    throw UsageError({"--size", "cannot be read as a size", text,
                      fmt::format("WxH in pixels, each from 1 to {}, as 1280x720", kMaxSidePx),
                      ""});
}

std::filesystem::path outputName(const std::filesystem::path& out, int time, bool several) {
    if (!several) return out;
    const std::string name =
        fmt::format("{}_{:04}{}", out.stem().string(), time, out.extension().string());
    return out.parent_path() / name;
}

int runRender(const RenderOptions& options) {
    checkOptions(options);
    const std::optional<Region> region = parseRegion(options.scene.region);
    Scene scene = makeScene(options.scene);
    applyPlanes(options, scene.document.look);
    printAll("warning", scene.warnings);
    const auto dataset =
        Dataset::open(listFiles(options.scene.files), PluginHost::standard(options.scene.readers));
    printAll("note", dataset->info().notes);
    const std::vector<int> times = parseTimes(options.scene.time, dataset->info());
    const gl::HeadlessContext context;
    render::Renderer renderer(resourcePath("shaders"));
    std::vector<std::string> warnings;
    const VolumeRequest request{
        region, chooseBudget(options.scene.memory, rendererBytes(gl::deviceMemory()), warnings),
        planRadii(scene.document.look, dataset->info())};
    printAll("warning", warnings);
    Run run{options, scene, *dataset, request, renderer};
    for (const int time : times) renderTime(run, time, times.size() > 1);
    return 0;
}

}  // namespace neph
