// render_command.cpp: opens, resamples, renders and writes, one time after the other.
#include "app/cli/render_command.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>

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

Metadata describe(const RenderOptions& options, const Scene& scene, const DatasetInfo& info,
                  const SpeciesVolume& volume, const TimeInfo& time,
                  const render::FrameStats& stats, const std::string& device) {
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
         fmt::format("{}; {}; file {}; time {}; reader {}", info.model, info.scheme,
                     time.file.filename().string(), volume.timeLabel, info.reader)},
        {"nephoscope.renderer",
         fmt::format("{} engine, {} planes, {}", options.engine, stats.planes, device)},
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

/// One time: read, render, write, and say so.
void renderTime(const RenderOptions& options, const Scene& scene, Dataset& dataset, int time,
                bool several, const VolumeRequest& request, render::Renderer& renderer) {
    const HeldVolume held = readVolume(dataset, time, request);
    const SpeciesVolume& volume = held.volume;
    printAll("note", volume.notes);
    if (const std::string plan = neph::describe(held.summary.plan, dataset.info()); !plan.empty()) {
        printAll("note", {plan});
    }
    renderer.setVolume(volume);
    render::FrameInputs inputs;
    inputs.look = scene.document.look;
    inputs.sizePx = parseSize(options.size);
    inputs.camera = placeCamera(scene.document.camera, volume.grid,
                                static_cast<double>(inputs.sizePx.x) / inputs.sizePx.y);
    const render::FrameStats stats = renderer.render(inputs);
    printAll("warning", renderer.takeMessages());
    const TimeInfo& info = dataset.info().times[static_cast<std::size_t>(time)];
    const auto out = outputName(options.out, time, several);
    write(options, out, renderer,
          describe(options, scene, dataset.info(), volume, info, stats, renderer.deviceName()));
    fmt::print(stderr, "wrote {} ({}x{}, {}, {} planes, {:.0f} ms)\n", out.string(),
               inputs.sizePx.x, inputs.sizePx.y, volume.timeLabel, stats.planes,
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
    for (const int time : times) {
        renderTime(options, scene, *dataset, time, times.size() > 1, request, renderer);
    }
    return 0;
}

}  // namespace neph
