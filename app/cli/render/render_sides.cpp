// render_sides.cpp: scenes from requests and sessions; data to the renderer.
#include "app/cli/render/render_sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/resources.h"
#include "core/dataset/ensemble.h"
#include "core/look/exposure.h"
#include "core/plugin/plugin_host.h"
#include "core/preset/preset_files.h"
#include "core/volume/scale_data.h"

namespace neph {
namespace {

/// The scene of the request, upon what a slot keeps.
SideScene sceneOf(SceneRequest request, const SlotState* slot) {
    SideScene side;
    std::optional<Scene> start;
    if (slot != nullptr) {
        start = Scene{slot->presetName, slot->document, {}, slot->inMetres, true};
        if (request.files.empty() && request.members.empty()) {
            (slot->members ? request.members : request.files) = slot->data;
        }
        if (!request.region) request.region = slot->region;
        side.time = slot->document.time;
    }
    side.scene = makeScene(request, start);
    side.request = std::move(request);
    return side;
}

const SlotState* slotOf(const SessionState& session, int number) {
    const int index = number > 0 ? number - 1 : session.active;
    if (index < static_cast<int>(session.slots.size())) {
        return &session.slots.at(static_cast<std::size_t>(index));
    }
    throw UsageError({.where = "--slot",
                      .what = "the session has no such slot",
                      .found = std::to_string(number),
                      .expected = fmt::format("1 to {}", session.slots.size())});
}

/// B is seen as A is but for what the request says.
SideScene otherScene(const RenderRequest& request, const std::optional<SessionState>& session,
                     const SlotState* first) {
    const BesideRequest& beside = request.beside;
    SceneRequest other = request.scene;
    if (!beside.preset.empty()) other.preset = beside.preset;
    if (beside.time) other.times = beside.time;
    if (!beside.member.empty()) other.member = beside.member;
    SideScene side = sceneOf(std::move(other), beside.slots ? slotOf(*session, 2) : first);
    side.ownCamera = beside.slots && !session->linkedCameras && request.scene.camera.empty();
    return side;
}

/// "file wrfout_d01", "member mem03 of 5", "mean of 5 members".
std::string sourceOf(const Dataset& dataset, int member, const TimeInfo& time) {
    const Ensemble* ensemble = ensembleOf(dataset);
    if (ensemble == nullptr) return "file " + time.file.filename().string();
    if (member == kMeanMember) return fmt::format("mean of {} members", ensemble->count());
    return fmt::format("member {} of {}", ensemble->nameOf(member), ensemble->count());
}

}  // namespace

void checkActing(const RenderRequest& request, unsigned engines, unsigned sampled) {
    for (const Setting& setting : request.scene.engineSettings) {
        checkActing(setting.option, setting.row->engines, engines);
    }
    if (request.sampling.samples) checkActing("--samples", sampled, engines);
}

std::vector<SideScene> sideScenes(const RenderRequest& request,
                                  const std::optional<SessionState>& session) {
    const bool slots = request.beside.slots;
    const SlotState* first = session ? slotOf(*session, slots ? 1 : request.slot) : nullptr;
    std::vector<SideScene> sides{sceneOf(request.scene, first)};
    if (!request.beside.wanted()) return sides;
    sides.push_back(otherScene(request, session, first));
    // Linked cameras are those of the slot that was edited.
    if (slots && session->linkedCameras && request.scene.camera.empty()) {
        sides[0].scene.document.camera = slotOf(*session, 0)->document.camera;
    }
    return sides;
}

Side::Side(SideScene what, const MemoryBudget& budget, const Progress& progress)
    : what_(std::move(what)),
      dataset_(openData(what_.request.files, what_.request.members,
                        PluginHost::standard(what_.request.readers, what_.request.map), progress)),
      request_{what_.request.region, budget, planRadii(what_.scene.document.look, dataset_->info()),
               asksHumidity(what_.scene.document.look),
               memberOf(*dataset_, what_.request.member, what_.scene.document.member)},
      renderer_(std::make_unique<render::Renderer>(resourcePath("shaders"))),
      notes_(dataset_->info().notes) {
    Scene& scene = what_.scene;
    notes_.push_back(bringToCells(scene.document.look, std::exchange(scene.inMetres, 0),
                                  dataset_->finestCellM()));
}

std::vector<int> Side::times() const {
    if (!what_.request.times && what_.time) {
        return {std::clamp(*what_.time, 0, static_cast<int>(info().times.size()) - 1)};
    }
    return timesOf(what_.request.times, info());
}

void Side::show(int time, const Progress& progress) {
    if (time == time_) return;
    const HeldVolume held = readVolume(*dataset_, time, request_, progress);
    renderer_->setVolume(*held.volume);
    shown_ = held.summary;
    time_ = time;
    notes_ = held.volume->notes;
    notes_.push_back(neph::describe(shown_.plan, info()));
    const std::vector<std::string> off = notToScale(parameters().look, scaleDataOf(info(), shown_));
    if (!off.empty()) notes_.push_back(scaleText(off));
    if (shown_.where.humidity) {
        notes_.push_back(fmt::format("{}: {}.", shown_.timeLabel,
                                     hazeText(hazeOf(parameters().look, shown_.where))));
    }
    notes_.push_back(hazeNote(parameters().look, shown_.where, shown_.timeLabel, shown_.noHumidity,
                              shown_.noAerosol));
}

std::string Side::memberName() const {
    const Ensemble* ensemble = ensembleOf(*dataset_);
    return ensemble == nullptr ? std::string() : ensemble->nameOf(request_.member);
}

std::vector<std::string> Side::newNotes() {
    std::vector<std::string> fresh;
    for (std::string& note : std::exchange(notes_, {})) {
        if (note.empty() || std::ranges::find(told_, note) != told_.end()) continue;
        told_.push_back(note);
        fresh.push_back(std::move(note));
    }
    return fresh;
}

Metadata Side::describe(const ParameterSet& drawn, const CameraPose& pose,
                        const std::string& work) const {
    const std::string plan = neph::describe(shown_.plan, info());
    const std::string name = presetLabel(what_.scene.presetName);
    const TimeInfo& time = info().times.at(static_cast<std::size_t>(time_));
    return {
        {"preset", name},
        {"camera", fmt::format("target {},{},{} distance {} azimuth {} elevation {} fov {}",
                               pose.target.x, pose.target.y, pose.target.z, pose.distance,
                               pose.azimuthDeg, pose.elevationDeg, pose.fovDeg)},
        {"look", formatPreset(Preset{name, "", drawn.look, pose})},
        {"sun", sunText(sunStateOf(drawn.look, shown_.where))},
        {"exposure",
         fmt::format("EV100 {:.2f}", exposureValue(lookAsDrawn(drawn.look, shown_.where)))},
        {"haze", hazeText(hazeOf(drawn.look, shown_.where))},
        {"scale", scaleOf(drawn.look)},
        {"sampling", formatAssignments(samplingTable(), drawn)},
        {"data",
         fmt::format("{}; {}; {}; time {}; reader {}", info().model, info().scheme,
                     sourceOf(*dataset_, request_.member, time), shown_.timeLabel, info().reader)},
        {"resolution", plan.empty() ? "full" : plan},
        {"renderer", fmt::format("{}, {}", work, renderer_->deviceName())},
    };
}

std::string Side::scaleOf(const Look& look) const {
    return scaleText(notToScale(look, scaleDataOf(info(), shown_)));
}

}  // namespace neph
