// slot.cpp: from a document to the picture on the screen, by way of drafts.
#include "app/slot.h"

#include <utility>

#include "app/cli/profile_text.h"

namespace neph {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

void Slot::takeData() {
    session.poll();
    try {
        if (const auto volume = session.takeVolume()) {
            renderer_.setVolume(*volume);
            drawn_.reset();
            changed_ = Clock::now();
        }
    } catch (const Error& error) {
        session.say(Message::Kind::error, error.message());
    }
}

void Slot::noteChanges() {
    if (session.document != seen_) {
        changed_ = Clock::now();
        drawn_.reset();
        seen_ = session.document;
    }
}

double Slot::restS() const {
    return std::chrono::duration<double>(Clock::now() - changed_).count();
}

bool Slot::averages(bool moving) const {
    return !moving && session.document.look.engine == Engine::march;
}

Slot::Waiting Slot::waiting(bool moving) const {
    if (!session.shown()) return Waiting::no;
    if (!drawn_) return Waiting::now;
    if (drawn_->step < ui::kFullStep) return Waiting::rest;
    return averages(moving) && drawn_->sample + 1 < ui::kSamples ? Waiting::now : Waiting::no;
}

render::FrameInputs Slot::inputsOf(const ui::Draft& draft, const DrawRequest& request) const {
    render::FrameInputs inputs;
    inputs.look = session.document.look;
    inputs.sizePx = draft.sizePx;
    inputs.sample = draft.sample;
    inputs.draftLight = draft.step == 0;
    inputs.profile = request.profile;
    if (inputs.look.engine == Engine::slicing) {
        inputs.planes = ui::planesOf(draft, inputs.look.planes);
    } else {
        inputs.look.quality *= static_cast<float>(draft.detail);
    }
    inputs.camera = placeCamera(session.document.camera, session.shown()->grid,
                                static_cast<double>(request.placePx.x) / request.placePx.y);
    return inputs;
}

std::optional<render::FrameStats> Slot::render(const ui::Draft& draft,
                                               const render::FrameInputs& inputs,
                                               const DrawRequest& request) {
    double panelsMs = 0.0;
    try {
        // A frame in motion is short and always comes through; a refinement gives way to the hand.
        render::FrameStats stats = renderer_.render(inputs, [&](double) {
            panelsMs += request.panels();
            return draft.step == 0 || !(changedSinceLastLook() || request.giveWay());
        });
        stats.milliseconds -= panelsMs;
        return stats;
    } catch (const Cancelled&) {
        return {};
    }
}

bool Slot::draw(const DrawRequest& request, ui::Profile& profile) {
    if (!session.shown()) return false;
    noteChanges();  // a further sample of another picture would be no average
    if (placePx_ != request.placePx) {
        placePx_ = request.placePx;
        changed_ = Clock::now();
        drawn_.reset();
    }
    const Engine engine = session.document.look.engine;
    // A button held still is still motion: the next move must find the machine ready.
    const double rest = request.moving ? 0.0 : restS();
    quality_.setFrameMs(request.frameMs);
    const std::optional<ui::Draft> next =
        ui::nextDraft(drawn_, quality_.draft(rest, placePx_, ui::leastDetailOf(engine)),
                      averages(request.moving));
    if (!next) return false;
    const render::FrameInputs inputs = inputsOf(*next, request);
    // Until the data of another time are there the picture is of the time before.
    const int time = session.shows(session.document.time) ? session.document.time : report.time;
    const std::optional<render::FrameStats> stats = render(*next, inputs, request);
    if (!stats) return false;
    // What the camera does not change is no measure of how finely to draw while it moves.
    const bool prepared = stats->bakedMedium || (engine == Engine::march && stats->marchedLight);
    if (stats->marchedEye && !prepared) quality_.measured(*next, stats->milliseconds, placePx_);
    report = {stats->milliseconds,
              engine,
              stats->planes,
              next->sample + 1,
              next->sizePx,
              next->step == ui::kFullStep,
              renderer_.deviceName(),
              renderer_.gpuBytes(),
              time};
    if (inputs.profile) ui::update(profile, profileOf(*stats, inputs, renderer_), !drawn_);
    drawn_ = next;
    for (std::string& message : renderer_.takeMessages()) {
        session.say(Message::Kind::warning, std::move(message));
    }
    return true;
}

void Slot::reloadShaders() {
    renderer_.reloadChangedShaders();
    drawn_.reset();
}

}  // namespace neph
