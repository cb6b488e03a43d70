// render_arguments.cpp: each option of `render`, the field of RenderRequest that it fills, and what
// does not go together.
#include "app/cli/render/render_arguments.h"

#include <fmt/format.h>

#include <memory>

#include "app/cli/common/progress_lines.h"
#include "app/cli/render/render_command.h"
#include "app/cli/render/video.h"
#include "core/base/atomic_file.h"

namespace neph {
namespace {

constexpr int kMaxSupersample = 4, kMaxSamples = 65536;
constexpr double kMinMeasureS = 0.1, kMaxMeasureS = 86400.0;
constexpr double kMinFps = 0.1, kMaxFps = 240.0;

ExrPixels parseFormat(const std::string& text) {
    if (text == "half") return ExrPixels::half;
    if (text == "float") return ExrPixels::full;
    throw UsageError({"--format", "is not known", text, "half or float", ""});
}

void addOutputOptions(CLI::App& command, RenderRequest& request) {
    const auto parseOut = [](const std::string& text) {
        kindOf(text);
        return std::filesystem::path(text);
    };
    addParsed(command, "--out,-o", request.out, parseOut, "Image to write, or video of all frames",
              "nephoscope.png")
        ->type_name("P.png|P.exr|P.mp4");
    addSizeOption(command, request.sizePx, "In pixels");
    addParsed(command, "--format", request.format, parseFormat, "Pixels of an EXR: half or float",
              "half");
    addNumber(command, "--supersample", request.supersample, 1, kMaxSupersample,
              "Rays per pixel, a side: 1 to 4", "1");
    command.add_flag("--fix-camera", request.fixCamera,
                     "The camera stays on the ground where the grid moves");
    command.add_flag("--transparent", request.transparent, "Without sky and ground");
    command.add_flag("--denoise", request.denoise,
                     "Reference: a preview without most of its noise, marked so");
    command.add_flag("--profile", request.profile, "Print time of each pass, samples, memory");
    addNumber(command, "--measure-error", request.measureErrorS, kMinMeasureS, kMaxMeasureS,
              "State the image's error against the reference, traced for so many seconds at most")
        ->type_name("SECONDS");
    command.add_flag("--progress", request.progress, "A JSON object per image on stdout");
}

/// Where the image starts from, and where the camera goes.
void addCameraOptions(CLI::App& command, RenderRequest& request) {
    command.add_option("--session", request.session, "Start from what a session file holds")
        ->type_name("FILE");
    addNumber(command, "--slot", request.slot, 1, 2, "Of the session; else the one last edited")
        ->type_name("1|2");
    addViewOptions(command, request.from);
    command.add_option("--path", request.path, "Frames along a camera path")->type_name("FILE");
    command.add_flag("--along-path", request.alongPath, "Along the camera path of the session");
    addNumber(command, "--fps", request.fps, kMinFps, kMaxFps,
              "Frames per second, of videos and paths", "25");
    addNumber(command, "--frames", request.frames, 1, kMaxFrames,
              "Frames along the path; else as --fps says");
}

void addBesideOptions(CLI::App& command, BesideRequest& beside) {
    command.add_flag("--compare", beside.slots, "Both slots of the session side by side");
    command.add_option("--preset-b", beside.preset, "Beside the image: another preset")
        ->type_name("NAME|FILE");
    const auto parseTime = [](const std::string& text) {
        const TimeRange time = parseTimeRange("--time-b", text);
        checkOneTime(time);
        return time;
    };
    addParsed(command, "--time-b", beside.time, parseTime, "Beside the image: another time")
        ->type_name("INDEX");
    command.add_option("--member-b", beside.member, "Beside the image: another member, or mean")
        ->type_name("NAME|N|mean");
    addParsed(command, "--split", beside.splitAt, parseSplit, "Share of the width for the first")
        ->type_name("SHARE");
}

void checkSession(const CLI::App& command, const RenderRequest& request) {
    if (request.session.empty()) {
        refuseTyped(command, {"--slot", "--compare", "--along-path"}, "needs a session",
                    "--session FILE; or --preset-b, --time-b, --member-b, --path FILE");
    }
    if (request.beside.slots) {
        refuseTyped(command, {"--slot"}, "--compare shows both slots", "leave out one of the two");
    }
    if (!request.beside.wanted()) {
        refuseTyped(command, {"--split"}, "there is nothing to compare with",
                    "--preset-b, --time-b, --member-b, or --session with --compare");
    }
}

void checkPath(const CLI::App& command, const RenderRequest& request) {
    const bool path = request.alongPath || !request.path.empty();
    if (request.alongPath) {
        refuseTyped(command, {"--path"}, "there is --along-path as well", "give one of the two");
    }
    checkView(request.from);
    if (path) {
        refuseTyped(command, {"--observer", "--view"}, "there is a camera path as well",
                    "give one of the two");
    } else {
        refuseTyped(command, {"--frames"}, "there is no camera path",
                    "--path FILE; --time chooses among the times of the data");
    }
    const bool counted = path && request.frames == 0;
    if (!counted && kindOf(request.out) != OutputKind::mp4) {
        refuseTyped(command, {"--fps"}, "nothing is played here",
                    path ? "--frames says how many there are; leave out one of the two"
                         : "--out FILE.mp4 for a video, or --path FILE");
    }
}

void checkOutput(const CLI::App& command, const RenderRequest& request) {
    const OutputKind kind = kindOf(request.out);
    if (kind != OutputKind::exr) {
        refuseTyped(command, {"--format"}, "is of EXR files", "--out FILE.exr");
    }
    if (request.beside.wanted()) {
        refuseTyped(command, {"--measure-error"}, "two images share this one",
                    "render them one by one");
    }
    if (kind == OutputKind::mp4) {
        refuseTyped(command, {"--measure-error"}, "a video has no place for it",
                    "write images: --out frames.png");
        refuseTyped(command, {"--transparent"}, "a video is opaque",
                    "write images: --out frames.png");
        const glm::ivec2 size = videoSize(request.sizePx);
        if (size.x < 2 || size.y < 2) {
            throw UsageError({"--size", "is too small for a video", "", "2x2 or more", ""});
        }
        findFfmpeg();
    }
    if (request.supersample > 1) {
        refuseTyped(command, {"--denoise"}, "takes noise off images of one ray per pixel",
                    "leave out --supersample");
    }
    if (request.beside.wanted()) {
        refuseTyped(command, {"--denoise"}, "is for one image, and this is two side by side",
                    "render them one after the other");
    }
    if (request.sampling.samples == 1) {
        refuseTyped(command, {"--denoise"}, "needs two samples to know what is noise",
                    "--samples 2 or more");
    }
    checkReplaceable(request.out);  // now rather than after the work
}

void check(const CLI::App& command, const RenderRequest& request) {
    const bool anyPreset = !request.scene.preset.empty() || !request.beside.preset.empty();
    checkScene(command, request.scene, anyPreset);
    checkSession(command, request);
    checkPath(command, request);
    checkOutput(command, request);
}

}  // namespace

void addViewOptions(CLI::App& command, RenderView& from) {
    addParsed(command, "--observer", from.observer, parseObserver,
              "Look from a place; km, km, m, then degrees")
        ->type_name("EAST,NORTH,HEIGHT,AZIMUTH,ELEVATION[,FOV]");
    addParsed(command, "--view", from.view, parseView, "Look from a side, all clouds in the image")
        ->type_name("fit|plan|north|east|south|west|below");
}

void checkView(const RenderView& from) {
    if (!from.observer || !from.view) return;
    throw UsageError({.where = "--view",
                      .what = "there is an --observer as well",
                      .hint = "give one of the two"});
}

void addSizeOption(CLI::App& command, glm::ivec2& sizePx, const std::string& help) {
    addParsed(command, "--size", sizePx, parseSize, help, fmt::format("{}x{}", sizePx.x, sizePx.y))
        ->type_name("WxH");
}

void addSampleOptions(CLI::App& command, RenderRequest& request, const std::string& samplesHelp) {
    addAlias(command, "--planes", request.scene);
    addNumber(command, "--samples", request.sampling.samples, 1, kMaxSamples, samplesHelp);
    addAlias(command, "--error", request.scene);
    addAlias(command, "--seed", request.scene);
}

Command addRender(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("render", "Render to a file; needs no display");
    const auto request = std::make_shared<RenderRequest>();
    addSceneOptions(command, request->scene);
    addOutputOptions(command, *request);
    addAlias(command, "--engine", request->scene);
    addAlias(command, "--quality", request->scene);
    addSampleOptions(
        command, *request,
        "Frames averaged, march: else 8; samples per pixel, reference: else as --error");
    addCameraOptions(command, *request);
    addBesideOptions(command, request->beside);
    return {&command, [&command, request] {
                request->sampling.error = command.count("--error") > 0;
                try {
                    check(command, *request);
                    return runRender(*request);
                } catch (const Error& error) {
                    if (request->progress) ProgressLines::failed(error.message());
                    throw;
                }
            }};
}

}  // namespace neph
