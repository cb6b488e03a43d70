// render_command.cpp: one image after the other is drawn and written, or handed to the video.
#include "app/cli/render/render_command.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/common/interrupt.h"
#include "app/cli/common/progress_lines.h"
#include "app/cli/render/bands.h"
#include "app/cli/render/reference_channels.h"
#include "app/cli/render/render_error.h"
#include "app/cli/render/render_sides.h"
#include "app/cli/render/render_view.h"
#include "app/cli/render/shots.h"
#include "app/cli/render/video.h"
#include "app/gl/context.h"
#include "app/image_io/exr.h"
#include "app/image_io/png.h"
#include "app/render/frame/tiles.h"
#include "app/workbench/error_measurement.h"
#include "app/workbench/profile_text.h"
#include "core/base/atomic_file.h"
#include "core/base/resources.h"
#include "core/camera/camera_format.h"
#include "core/session/session_file.h"

namespace neph {
namespace {

void printAll(std::string_view kind, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) fmt::print(stderr, "{}: {}\n", kind, line);
}

/// What all images of one command share.
class Run {
  public:
    Run(const RenderRequest& request, Progress goesOn);
    void all();

  private:
    DrawnSide drawn(std::size_t index, const Shot& shot);
    Bands bandsOf(const Shot& shot);
    int timeOf(std::size_t index, const Shot& shot) const;
    Metadata describe(const Shot& shot, const Bands& bands) const;
    CameraPose poseOf(std::size_t index, const Shot& shot) const;
    std::size_t posedTime(const Side& own) const;
    double aspect() const { return static_cast<double>(sizePx_.x) / sizePx_.y; }
    void write(const Shot& shot, Bands& bands);
    template <typename Next>
    auto drawAhead(const Bands& bands, Next next);
    void say(const Bands& bands, const std::filesystem::path& file);
    void image(const Shot& shot, const std::function<void(Bands&)>& take,
               const std::filesystem::path& file);
    const RenderRequest& request_;
    Progress goesOn_;
    std::optional<CameraPath> path_;
    std::optional<CameraPose> fromPose_;  // of the first time: it does not jump from time to time
    double splitAt_ = 0.5;
    gl::HeadlessContext context_;
    std::vector<std::unique_ptr<Side>> sides_;
    std::vector<Shot> shots_;
    glm::ivec2 sizePx_{0};
    std::optional<ProgressLines> progress_;
    std::optional<MeasuredError> error_;  // of the image that was drawn last
};

void checkEngines(const RenderRequest& request, const std::vector<SideScene>& scenes) {
    unsigned engines = 0;
    for (const SideScene& side : scenes) engines |= bitOf(side.scene.document.look.engine);
    if (request.measureErrorS && (engines & bitOf(groundTruth())) != 0) {
        throw UsageError({.where = "--measure-error",
                          .what = "the image is of the engine that errors are measured against",
                          .found = std::string(traitsOf(groundTruth()).id),
                          .hint = "its own standard error is printed in any case; another --engine "
                                  "has an error to measure"});
    }
    checkActing(request, engines,
                kAllEngines & ~enginesWith(&EngineTraits::refinement, Refinement::once));
    if (request.denoise) {
        checkActing("--denoise", enginesWith(&EngineTraits::layers, true), engines);
    }
}

/// The seams of tiles would show in a denoised image.
void checkOneTile(glm::ivec2 sizePx, int largestSidePx) {
    if (render::tileSize(sizePx, 1, largestSidePx, render::kMostTileRays) == sizePx) return;
    throw UsageError({.where = "--denoise",
                      .what = "an image of this size is drawn in tiles, whose seams would show",
                      .found = fmt::format("{} x {} px", sizePx.x, sizePx.y),
                      .expected = fmt::format("at most {} px a side and {} px in all",
                                              largestSidePx, render::kMostTileRays),
                      .hint = "a smaller --size"});
}

/// The camera path that is asked for.
std::optional<CameraPath> pathOf(const RenderRequest& request, const SideScene& first,
                                 std::vector<std::string>& warnings) {
    std::optional<CameraPath> path;
    if (!request.path.empty()) {
        path = loadCameraPath(request.path, warnings);
    } else if (request.alongPath) {
        path = first.scene.document.path;
    }
    if (!path || !path->keys.empty()) return path;
    throw Error({.where = (request.path.empty() ? request.session : request.path).string(),
                 .what = "there is no camera path",
                 .found = "no keys",
                 .hint = "set keys in the camera panel, or write them"});
}

Run::Run(const RenderRequest& request, Progress goesOn)
    : request_(request), goesOn_(std::move(goesOn)) {
    std::vector<std::string> warnings;
    std::optional<SessionState> session;
    if (!request.session.empty()) session = loadSession(request.session, warnings);
    std::vector<SideScene> scenes = sideScenes(request, session);
    if (session) splitAt_ = static_cast<double>(session->splitAt);
    splitAt_ = request.beside.splitAt.value_or(splitAt_);
    checkEngines(request, scenes);
    path_ = pathOf(request, scenes.front(), warnings);
    MemoryBudget budget =
        chooseBudget(request.scene.memory, rendererBytes(gl::deviceMemory()), warnings);
    budget.gpu /= scenes.size();
    budget.machine /= scenes.size();
    for (SideScene& scene : scenes) {
        warnings.insert(warnings.end(), scene.scene.warnings.begin(), scene.scene.warnings.end());
    }
    printAll("warning", warnings);
    const bool allTimes = path_ && path_->withTime && !request.scene.times;
    for (SideScene& scene : scenes) {
        if (allTimes && !scene.request.times) scene.request.times = TimeRange{0, -1, "--time all"};
        sides_.push_back(std::make_unique<Side>(std::move(scene), budget, goesOn_));
        printAll("note", sides_.back()->newNotes());
    }
    shots_ = planShots(request, path_, sides_.front()->times());
    sizePx_ = request.sizePx;
    if (kindOf(request.out) == OutputKind::mp4 && videoSize(sizePx_) != sizePx_) {
        sizePx_ = videoSize(sizePx_);
        printAll("note", {fmt::format("a video has even sides: {}x{}", sizePx_.x, sizePx_.y)});
    }
    if (request.denoise) checkOneTile(sizePx_, sides_.front()->renderer().largestSidePx());
    progress_.emplace(request.progress, shots_.size());
}

/// B follows A through the times, unless it has one of its own.
int Run::timeOf(std::size_t index, const Shot& shot) const {
    if (index == 0) return shot.time;
    const Side& side = *sides_[index];
    const bool own = request_.beside.time.has_value() ||
                     (request_.beside.slots && shots_.size() == 1 && !request_.scene.times);
    return own ? side.times().front()
               : std::min(shot.time, static_cast<int>(side.info().times.size()) - 1);
}

CameraPose Run::poseOf(std::size_t index, const Shot& shot) const {
    const Side& side = *sides_[index];
    const RegularGrid& grid = side.shown().grid;
    const Side& own = *sides_[side.what().ownCamera ? index : 0];
    CameraPose pose = shot.pathS  ? poseAt(*path_, grid, *shot.pathS)
                      : fromPose_ ? *fromPose_
                                  : own.what().scene.document.camera;
    pose.fixedToGround |= request_.fixCamera;
    keepOnGround(pose, grid, grid.movedM - own.info().times.at(posedTime(own)).gridOffsetM);
    return pose;
}

/// The time that poses of a side are relative to: that of the session where the camera is, else the
/// first that is drawn.
std::size_t Run::posedTime(const Side& own) const {
    const SideScene& what = own.what();
    const bool kept = what.time && !fromPose_ && what.request.camera.empty() &&
                      what.request.preset.empty() && request_.path.empty();
    const int last = static_cast<int>(own.info().times.size()) - 1;
    return static_cast<std::size_t>(std::clamp(kept ? *what.time : shots_.front().time, 0, last));
}

DrawnSide Run::drawn(std::size_t index, const Shot& shot) {
    Side& side = *sides_[index];
    side.show(timeOf(index, shot), goesOn_);
    const RenderView from = firstView(request_.from, sides_.front()->what().scene);
    if (from.given() && !fromPose_) {
        fromPose_ =
            neph::poseOf(from, poseOf(index, shot), side.shown(), side.parameters().look, aspect());
    }
    printAll("note", side.newNotes());
    DrawnSide drawn;
    drawn.renderer = &side.renderer();
    drawn.inputs.look = side.drawnLook();
    drawn.inputs.sampling = side.parameters().sampling;
    const SamplePlan plan = planSamples(request_.sampling, side.parameters());
    drawn.samples = plan.samples;
    drawn.targetError = plan.targetError;
    drawn.inputs.sizePx = sizePx_;
    drawn.inputs.supersample = request_.supersample;
    drawn.inputs.backdrop = !request_.transparent;
    drawn.inputs.profile = request_.profile;
    drawn.denoise = request_.denoise;
    drawn.inputs.camera = placeCamera(poseOf(index, shot), side.shown().grid, aspect());
    const int split =
        sides_.size() == 1
            ? sizePx_.x
            : std::clamp(static_cast<int>(std::lround(splitAt_ * sizePx_.x)), 0, sizePx_.x);
    drawn.fromPx = index == 0 ? 0 : split;
    drawn.toPx = index == 0 ? split : sizePx_.x;
    return drawn;
}

Bands Run::bandsOf(const Shot& shot) {
    std::vector<DrawnSide> drawnSides;
    for (std::size_t i = 0; i < sides_.size(); ++i) drawnSides.push_back(drawn(i, shot));
    return {std::move(drawnSides), [this](double share) {
                progress_->part(share);
                return goOn(goesOn_, share);
            }};
}

Metadata Run::describe(const Shot& shot, const Bands& bands) const {
    Metadata all{{"Software", fmt::format("Nephoscope {}", versionText())}};
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        const char* of = i == 0 ? "nephoscope." : "nephoscope.b.";
        const std::string work = workText(bands.sides()[i], bands.stats());
        for (auto& [key, text] :
             sides_[i]->describe(sides_[i]->parameters(), poseOf(i, shot), work)) {
            all.emplace_back(of + key, text);
        }
    }
    if (error_) all.emplace_back("nephoscope.error", errorJson(*error_));
    if (request_.denoise) all.emplace_back(kDenoisedKey, kDenoisedText);
    return all;
}

int rowsOf(const Image8& band) {
    return band.size.y;
}
int rowsOf(const LayeredImage& band) {
    return band.colours.size.y;
}

/// The bands that are drawn before the file is begun, since its metadata say what they took: the
/// first, or all where they say how far the image is off. Then the error is measured.
template <typename Next>
auto Run::drawAhead(const Bands& bands, Next next) {
    std::deque<decltype(next())> drawn;
    drawn.push_back(next());
    error_.reset();
    if (!request_.measureErrorS) return drawn;
    for (int rows = rowsOf(drawn.front()); rows < sizePx_.y; rows += rowsOf(drawn.back())) {
        drawn.push_back(next());
    }
    error_ = errorOf(bands, *request_.measureErrorS, goesOn_);
    return drawn;
}

void Run::write(const Shot& shot, Bands& bands) {
    if (request_.measureErrorS) bands.average(ErrorMeasurement::sizeFor(sizePx_));
    // Those that were drawn ahead, then others.
    const auto inTurn = [](auto& ahead, const auto& next) {
        if (ahead.empty()) return next();
        auto band = std::move(ahead.front());
        ahead.pop_front();
        return band;
    };
    if (kindOf(shot.file) == OutputKind::png) {
        const auto next = [&] { return bands.nextDisplay(); };
        auto ahead = drawAhead(bands, next);
        writePng(shot.file, sizePx_, describe(shot, bands), [&] { return inTurn(ahead, next); });
    } else {
        const auto next = [&] { return bands.nextLayered(); };
        auto ahead = drawAhead(bands, next);
        bool radiance = true;
        for (const DrawnSide& side : bands.sides()) radiance &= showsRadiance(side.inputs.look);
        const std::size_t clipped =
            writeExr(shot.file, sizePx_, describe(shot, bands), {request_.format, radiance},
                     bands.layerNames(), [&] { return inTurn(ahead, next); });
        if (clipped > 0) {
            fmt::print(stderr,
                       "note: {}: {} values, as of the sun's disc, are more than half floats hold "
                       "(65504) and were clipped; --format float keeps them\n",
                       shot.file.string(), clipped);
        }
    }
}

/// One image: read, draw, hand over, and say so.
void Run::image(const Shot& shot, const std::function<void(Bands&)>& take,
                const std::filesystem::path& file) {
    Bands bands = bandsOf(shot);
    take(bands);
    for (const auto& side : sides_) printAll("warning", side->renderer().takeMessages());
    progress_->done(file);
    say(bands, file);
}

void Run::say(const Bands& bands, const std::filesystem::path& file) {
    const Side& first = *sides_.front();
    const bool video = kindOf(file) == OutputKind::mp4;
    fmt::print(stderr, "{} {} ({}x{}, {}, {}, {:.0f} ms)\n", video ? "an image of" : "wrote",
               file.string(), sizePx_.x, sizePx_.y, first.shown().timeLabel,
               workText(bands.sides()[0], bands.stats()), bands.stats().milliseconds);
    const std::string error =
        error_ ? fmt::format("{}: {}", errorText(*error_), meaningOf(*error_)) : std::string();
    if (!request_.profile) {
        if (error_) fmt::print(stderr, "error now: {}\n", error);
        return;
    }
    render::FrameInputs inputs;
    inputs.look = first.drawnLook();
    inputs.sampling = first.parameters().sampling;
    inputs.sizePx = sizePx_;
    ui::Profile profile = profileOf(bands.stats(), inputs, sides_.front()->renderer());
    if (error_) profile.error = error;
    fmt::print(stderr, "{}", profileText(profile));
}

void Run::all() {
    if (kindOf(request_.out) != OutputKind::mp4) {
        for (const Shot& shot : shots_) {
            image(
                shot, [&](Bands& bands) { write(shot, bands); }, shot.file);
        }
        return;
    }
    replaceFile(request_.out, [&](const std::filesystem::path& aside) {
        Video video(aside, sizePx_, request_.fps);
        for (const Shot& shot : shots_) {
            const auto add = [&](Bands& bands) {
                for (int rows = 0; rows < sizePx_.y;) {
                    const Image8 band = bands.nextDisplay();
                    video.add(band);
                    rows += band.size.y;
                }
            };
            image(shot, add, request_.out);
        }
        video.finish(goesOn_);
    });
    fmt::print(stderr, "wrote {}\n", request_.out.string());
}

}  // namespace

int runRender(const RenderRequest& request) {
    noteInterrupts();
    try {
        Run(request, untilInterrupted()).all();
    } catch (const Cancelled&) {
        fmt::print(stderr, "stopped; nothing is left half done\n");
        return 128 + interruptSignal();
    }
    return 0;
}

}  // namespace neph
