// render_sides.cpp: scenes from options and sessions; data to the renderer.
#include "app/cli/render/render_sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/resources.h"
#include "core/dataset/file_list.h"
#include "core/plugin/plugin_host.h"
#include "core/preset/preset_files.h"

namespace neph {
namespace {

/// Sets a parameter as the option of its own says, if it does. As part of the document, so that the
/// metadata name what renders the same image again.
void apply(ParameterSet& values, std::string_view option, const std::string& text) {
    if (text.empty()) return;
    try {
        const Parameter& row = parameterOfOption(option);
        setValue(values, row, parseScreenValue(row, text));
    } catch (const Error& error) {
        ErrorParts parts = error.parts();
        parts.where = option;
        throw UsageError(parts);
    }
}

/// The scene of the options, upon what a slot keeps.
SideScene sceneOf(const RenderOptions& options, SceneOptions typed, const SlotState* slot) {
    SideScene side;
    side.region = parseRegion(typed.region);
    std::optional<Scene> start;
    if (slot != nullptr) {
        start = Scene{slot->presetName, slot->document, {}};
        if (typed.files.empty()) typed.files = slot->data;
        if (typed.region.empty()) side.region = slot->region;
        side.time = slot->document.time;
    }
    side.scene = makeScene(typed, start);
    side.options = std::move(typed);
    Document& document = side.scene.document;
    apply(document, "--engine", options.engine);
    apply(document, "--quality", options.quality);
    apply(document, "--planes", options.planes);
    apply(document, "--seed", options.seed);
    apply(document, "--error", options.error);
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

/// B is seen as A is but for what the options say.
SideScene otherScene(const RenderOptions& options, const std::optional<SessionState>& session,
                     const SlotState* first) {
    const CompareOptions& compare = options.compare;
    SceneOptions typed = options.scene;
    if (!compare.preset.empty()) typed.preset = compare.preset;
    if (!compare.time.empty()) typed.time = compare.time;
    SideScene side = sceneOf(options, typed, compare.slots ? slotOf(*session, 2) : first);
    side.ownCamera = compare.slots && !session->linkedCameras && options.scene.camera.empty();
    return side;
}

}  // namespace

std::vector<SideScene> sideScenes(const RenderOptions& options,
                                  const std::optional<SessionState>& session) {
    if (!session && (options.compare.slots || options.slot > 0 || options.alongPath)) {
        throw UsageError({.what = "--slot, --compare and --along-path need a session",
                          .hint = "--session FILE; or --preset-b, --time-b, --path FILE"});
    }
    const int number = options.compare.slots ? 1 : options.slot;
    const SlotState* first = session ? slotOf(*session, number) : nullptr;
    std::vector<SideScene> sides{sceneOf(options, options.scene, first)};
    if (!options.compare.wanted()) return sides;
    sides.push_back(otherScene(options, session, first));
    // Linked cameras are those of the slot that was edited.
    if (options.compare.slots && session->linkedCameras && options.scene.camera.empty()) {
        sides[0].scene.document.camera = slotOf(*session, 0)->document.camera;
    }
    return sides;
}

Side::Side(SideScene what, const MemoryBudget& budget, const Progress& progress)
    : what_(std::move(what)),
      dataset_(Dataset::open(listFiles(what_.options.files),
                             PluginHost::standard(what_.options.readers), progress)),
      request_{what_.region, budget, planRadii(what_.scene.document.look, dataset_->info())},
      renderer_(std::make_unique<render::Renderer>(resourcePath("shaders"))),
      notes_(dataset_->info().notes) {}

std::vector<int> Side::times() const {
    if (what_.options.time.empty() && what_.time) {
        return {std::clamp(*what_.time, 0, static_cast<int>(info().times.size()) - 1)};
    }
    return parseTimes(what_.options.time, info());
}

void Side::show(int time, const Progress& progress) {
    if (time == time_) return;
    const HeldVolume held = readVolume(*dataset_, time, request_, progress);
    renderer_->setVolume(held.volume);
    shown_ = held.summary;
    time_ = time;
    notes_ = held.volume.notes;
    notes_.push_back(neph::describe(shown_.plan, info()));
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

Metadata Side::describe(const CameraPose& pose, const std::string& work) const {
    const std::string plan = neph::describe(shown_.plan, info());
    const std::string name = presetLabel(what_.scene.presetName);
    const TimeInfo& time = info().times.at(static_cast<std::size_t>(time_));
    return {
        {"preset", name},
        {"camera", fmt::format("target {},{},{} distance {} azimuth {} elevation {} fov {}",
                               pose.target.x, pose.target.y, pose.target.z, pose.distance,
                               pose.azimuthDeg, pose.elevationDeg, pose.fovDeg)},
        {"look", formatPreset(Preset{name, "", parameters().look, pose})},
        {"sampling", formatAssignments(samplingTable(), parameters())},
        {"data", fmt::format("{}; {}; file {}; time {}; reader {}", info().model, info().scheme,
                             time.file.filename().string(), shown_.timeLabel, info().reader)},
        {"resolution", plan.empty() ? "full" : plan},
        {"renderer", fmt::format("{}, {}", work, renderer_->deviceName())},
    };
}

}  // namespace neph
