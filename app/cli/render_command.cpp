// render_command.cpp: opens, resamples, renders and writes, one time after the other.
#include "app/cli/render_command.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <set>

#include "app/cli/profile_text.h"
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
constexpr int kMaxSamples = 1024;

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
    if (options.samples < 1 || options.samples > kMaxSamples) {
        throw UsageError({"--samples", "is outside its range", std::to_string(options.samples),
                          fmt::format("a whole number from 1 to {}", kMaxSamples), ""});
    }
    if (options.format != "half" && options.format != "float") {
        throw UsageError({"--format", "is not known", options.format, "half or float", ""});
    }
    parseSize(options.size);
    checkReplaceable(options.out);  // now rather than after the work
}

/// Sets a parameter as an option of its own says, if it does. As part of the look, so that the look
/// in the metadata renders the same picture again.
void apply(Look& look, std::string_view id, std::string_view option, const std::string& text) {
    if (text.empty()) return;
    try {
        const Parameter& row = parameter(id);
        setValue(look, row, parseValue(row, text));
    } catch (const Error& error) {
        ErrorParts parts = error.parts();
        parts.where = option;
        throw UsageError(parts);
    }
}

void applyOptions(const RenderOptions& options, Look& look) {
    apply(look, "view.engine", "--engine", options.engine);
    apply(look, "view.quality", "--quality", options.quality);
    apply(look, "view.planes", "--planes", options.planes);
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
    const Look& look() const { return scene.document.look; }
    /// Slicing draws the same picture every time.
    int samples() const { return look().engine == Engine::march ? options.samples : 1; }
};

/// How the picture was made: "march, 512 steps, 8 samples".
std::string workText(const Run& run, const render::FrameStats& stats) {
    if (run.look().engine == Engine::slicing)
        return fmt::format("slicing, {} planes", stats.planes);
    return fmt::format("march, {} steps, {} sample{}", stats.planes, run.samples(),
                       run.samples() == 1 ? "" : "s");
}

Metadata describe(const Run& run, const HeldVolume& held, const TimeInfo& time,
                  const render::FrameStats& stats) {
    const Scene& scene = run.scene;
    const std::string plan = neph::describe(held.summary.plan, run.info());
    const CameraPose& pose = scene.document.camera;
    const Preset preset{scene.presetName, "", run.look(), pose};
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
        {"nephoscope.renderer",
         fmt::format("{}, {}", workText(run, stats), run.renderer.deviceName())},
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

/// All samples of a picture; the time is that of all.
render::FrameStats drawSamples(Run& run, render::FrameInputs inputs) {
    render::FrameStats stats = run.renderer.render(inputs);
    while (++inputs.sample < run.samples()) {
        addSample(stats, run.renderer.render(inputs));
    }
    return stats;
}

/// One time: read, render, write, and say so.
void renderTime(Run& run, int time, bool several) {
    const HeldVolume held = readVolume(run.dataset, time, run.request);
    for (const std::string& note : held.volume.notes) sayOnce(run, note);
    sayOnce(run, neph::describe(held.summary.plan, run.info()));
    run.renderer.setVolume(held.volume);
    render::FrameInputs inputs;
    inputs.look = run.look();
    inputs.sizePx = parseSize(run.options.size);
    inputs.profile = run.options.profile;
    inputs.camera = placeCamera(run.scene.document.camera, held.volume.grid,
                                static_cast<double>(inputs.sizePx.x) / inputs.sizePx.y);
    const render::FrameStats stats = drawSamples(run, inputs);
    printAll("warning", run.renderer.takeMessages());
    const TimeInfo& info = run.info().times[static_cast<std::size_t>(time)];
    const auto out = outputName(run.options.out, time, several);
    write(run.options, out, run.renderer, describe(run, held, info, stats));
    fmt::print(stderr, "wrote {} ({}x{}, {}, {}, {:.0f} ms)\n", out.string(), inputs.sizePx.x,
               inputs.sizePx.y, held.volume.timeLabel, workText(run, stats), stats.milliseconds);
    if (inputs.profile) {
        fmt::print(stderr, "{}", profileText(profileOf(stats, inputs, run.renderer)));
    }
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
    applyOptions(options, scene.document.look);
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
