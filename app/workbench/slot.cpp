// slot.cpp: from a document to the image on the screen, by way of drafts.
#include "app/workbench/slot.h"

#include <utility>

#include "app/workbench/profile_text.h"
#include "core/look/haze.h"
#include "core/look/known_error.h"

namespace neph {
namespace {

using Clock = std::chrono::steady_clock;

// A frame in motion of an engine that converges is left for what the user did meanwhile where it
// takes longer.
constexpr std::chrono::seconds kLongestInMotion{1};

constexpr int kPreviewSamples = 2;  // the fewest that make two halves

bool converges(const Look& look) {
    return traitsOf(look.engine).refinement == Refinement::converges;
}

/// Whether samples that were gathered for the one are as good for the other.
bool sameSamples(const Document& a, const Document& b) {
    return a.camera == b.camera && a.time == b.time && converges(a.look) &&
           firstDifference(a, b).value_or(Stage::resolve) == Stage::resolve;
}

}  // namespace

void Slot::takeData() {
    session.poll();
    try {
        if (const auto volume = session.takeVolume()) {
            forgetError();  // before there are two volumes
            wantsError_ = false;
            preview_.forget();
            renderer_.setVolume(*volume);
            drawn_.reset();
            changed_ = Clock::now();
        }
    } catch (const Error& error) {
        session.say(Message::Kind::error, error.message());
    }
}

void Slot::noteChanges() {
    const double visibilityM = hazeOf(session.document.look, session.where()).visibilityM;
    const bool sameAir = visibilityM == seenVisibilityM_;
    if (session.document == seen_ && sameAir) return;
    changed_ = Clock::now();
    seenVisibilityM_ = visibilityM;
    if (drawn_ && drawn_->step == ui::kFullStep && sameAir &&
        sameSamples(session.document, seen_)) {
        retone_ = true;
    } else {
        drawn_.reset();
        forgetError();
        wantsError_ = false;
        preview_.forget();
    }
    seen_ = session.document;
}

double Slot::restS() const {
    return std::chrono::duration<double>(Clock::now() - changed_).count();
}

bool Slot::averages(bool moving) const {
    return !moving && traitsOf(session.document.look.engine).refinement == Refinement::averages;
}

/// With a target that was changed since the image was drawn, too.
bool Slot::addsPaths(bool moving) const {
    ReferenceProgress reached = report.reference;
    reached.targetError = static_cast<double>(session.document.sampling.targetError);
    return !moving && !isReached(reached);
}

Slot::Waiting Slot::waiting(bool moving) const {
    if (!session.shown()) return Waiting::no;
    if (!drawn_ || retone_ || renderer_.hasNewerLight()) return Waiting::now;
    if (drawn_->step < ui::kFullStep) return Waiting::rest;
    const bool further =
        converges() ? addsPaths(moving) : averages(moving) && drawn_->sample + 1 < ui::kSamples;
    if (further) return Waiting::now;
    return report.light && !report.light->settled ? Waiting::rest : Waiting::no;
}

render::FrameInputs Slot::inputsOf(const ui::Draft& draft, const DrawRequest& request) const {
    render::FrameInputs inputs;
    inputs.look = lookAsDrawn(session.document.look, session.where());
    inputs.sampling = session.document.sampling;
    inputs.sizePx = draft.sizePx;
    inputs.draftLight = draft.step == 0;
    inputs.settledLight = false;
    inputs.profile = request.profile;
    ui::thin(inputs, draft);
    inputs.camera = placeCamera(session.document.camera, session.shown()->grid,
                                static_cast<double>(request.placePx.x) / request.placePx.y);
    return inputs;
}

std::optional<render::FrameStats> Slot::render(const ui::Draft& draft,
                                               const render::FrameInputs& inputs,
                                               const DrawRequest& request) {
    const Clock::time_point start = Clock::now();
    double panelsMs = 0.0;
    if (draft.sample == 0) image_ = {};
    try {
        // A frame in motion is short and always comes through; a refinement yields to the user.
        render::FrameStats stats = renderer_.render(inputs, image_, [&](double) {
            panelsMs += request.panels();
            const bool slow =
                neph::converges(inputs.look) && Clock::now() - start > kLongestInMotion;
            if (draft.step == 0 && !slow) return true;
            return !(changedSinceLastLook() || request.yields());
        });
        stats.milliseconds -= panelsMs;
        return stats;
    } catch (const Cancelled&) {
        return {};
    }
}

/// The image to draw now, if any.
std::optional<ui::Draft> Slot::next(const DrawRequest& request) {
    if (std::exchange(retone_, false)) return drawn_;
    const Engine engine = session.document.look.engine;
    // A button held still is still motion: the next move must find the machine ready.
    const double rest = request.moving ? 0.0 : restS();
    ui::QualityControl& quality = qualityOf(engine);
    quality.setFrameMs(request.frameMs);
    const double leastDetail = traitsOf(engine).leastDetail;
    if (converges()) {
        return ui::nextTraced(drawn_, quality.draft(0.0, placePx_, leastDetail), placePx_, rest,
                              quality.fullMs(), addsPaths(request.moving),
                              request.preview ? kPreviewSamples : 1);
    }
    return ui::nextDraft(drawn_, quality.draft(rest, placePx_, leastDetail),
                         averages(request.moving));
}

/// Learns from an image of data of `time` what images cost, and reports it.
void Slot::tell(const ui::Draft& drawn, const ParameterSet& of, int time,
                const render::FrameStats& stats) {
    const Look& look = of.look;
    ui::QualityControl& quality = qualityOf(look.engine);
    const ReferenceProgress& traced = stats.reference;
    // What the camera does not change is no measure of how finely to draw while it moves.
    const bool prepared =
        stats.bakedMedium || (stats.marchedLight && !traitsOf(look.engine).lightFollowsCamera);
    if (neph::converges(look)) {
        // Later paths were begun with those before; a pass may have been taken up again.
        const bool first = stats.marchedEye && drawn.sample == 0;
        if (first) quality.measured(drawn, 1e3 * traced.seconds, placePx_);
    } else if (stats.marchedEye && !prepared) {
        quality.measured(drawn, stats.milliseconds, placePx_);
    }
    report = {.milliseconds = stats.milliseconds,
              .engine = look.engine,
              .planes = stats.planes,
              .samples = drawn.sample + 1,
              .sizePx = drawn.sizePx,
              .full = drawn.step == ui::kFullStep,
              .device = renderer_.deviceName(),
              .gpuBytes = renderer_.gpuBytes(),
              .time = time,
              .reference = traced,
              .previewSamples = renderer_.showsPreview() ? report.previewSamples : 0,
              .light = stats.light,
              .knownError = knownErrorText(look),
              .error = {}};
    report.reference.targetError = static_cast<double>(of.sampling.targetError);
}

bool Slot::draw(const DrawRequest& request, ui::Profile& profile) {
    if (!session.shown()) return false;
    noteChanges();  // a further sample of another image would be no average
    if (renderer_.hasNewerLight()) drawn_.reset();
    if (placePx_ != request.placePx) {
        placePx_ = request.placePx;
        changed_ = Clock::now();
        drawn_.reset();
        preview_.forget();
    }
    retone_ &= drawn_.has_value();
    const bool retones = retone_;
    const std::optional<ui::Draft> wanted = next(request);
    if (!wanted) return false;
    const render::FrameInputs inputs = inputsOf(*wanted, request);
    // Until the data of another time are there the image is of the time before.
    const int time = session.shows(session.document.time) ? session.document.time : report.time;
    const std::optional<render::FrameStats> stats =
        retones ? renderer_.retone(inputs.look) : render(*wanted, inputs, request);
    if (!stats) return false;
    tell(*wanted, inputs, time, *stats);
    if (inputs.profile && !retones)
        ui::update(profile, profileOf(*stats, inputs, renderer_), !drawn_);
    drawn_ = wanted;
    if (!retones) {
        ++images_;
        forgetError();
    }
    for (std::string& message : renderer_.takeMessages()) {
        session.say(Message::Kind::warning, std::move(message));
    }
    return true;
}

void Slot::reloadShaders() {
    forgetError();
    preview_.forget();
    renderer_.reloadChangedShaders();
    drawn_.reset();
}

}  // namespace neph
