// workbench.cpp: the loop: input, panels, picture, in that order and only when something happens.
#include "app/workbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "app/cli/profile_text.h"
#include "app/gl/context.h"
#include "app/render/renderer.h"
#include "app/ui/actions.h"
#include "app/ui/quality.h"
#include "app/ui/ui.h"
#include "app/workbench_host.h"
#include "core/memory_setting.h"
#include "core/plugin_host.h"
#include "core/resources.h"
#include "core/settings.h"

namespace neph {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWidthPx = 1280, kHeightPx = 720;
constexpr double kIdleWaitS = 0.25;  // between looks when nothing happens: tooltips, text cursor
constexpr double kBusyWaitS = 0.05;  // while data load or the picture waits to be refined
constexpr double kCommitS = 0.4;     // at rest for so long: the gesture is over, one step of undo

bool isPresetFile(const std::filesystem::path& path) {
    return path.extension() == ".json";
}

class Workbench {
  public:
    explicit Workbench(const SceneOptions& options);
    void run();

  private:
    void takeInput();
    void takeData();
    render::FrameInputs inputsOf(const ui::Draft& draft) const;
    void drawPicture();
    void drawPanels();
    void carryOut();
    void setMemory(const std::string& memory);
    void noteChanges();
    double waitS() const;
    /// Whether further samples make the picture better, now.
    bool averages() const {
        return !interacting_ && session_.document.look.engine == Engine::march;
    }
    double restS() const { return std::chrono::duration<double>(Clock::now() - changed_).count(); }
    glm::ivec2 picturePx() const { return ui::pictureBox(ui_).size(); }

    gl::Window window_{kWidthPx, kHeightPx, "Nephoscope"};
    WorkbenchHost host_{window_};
    render::Renderer renderer_{resourcePath("shaders")};
    Session session_;
    ui::Ui ui_{session_};
    ui::QualityControl quality_;

    Document seen_;  // as of the last frame
    glm::ivec2 seenPx_{0};
    std::optional<ui::Draft> drawn_;  // none: to be drawn again
    Clock::time_point changed_ = Clock::now();
    bool interacting_ = false;
};

Workbench::Workbench(const SceneOptions& options)
    : session_(PluginHost::standard(options.readers), &WorkbenchHost::wake) {
    const Scene scene = makeScene(options);
    session_.document = seen_ = scene.document;
    session_.homeCamera = scene.document.camera;
    session_.presetName = scene.presetName;
    session_.history.restart(scene.document);
    std::vector<std::string> warnings = scene.warnings;
    session_.setBudget(chooseBudget(options.memory, rendererBytes(gl::deviceMemory()), warnings));
    for (const std::string& warning : warnings) session_.say(Message::Kind::warning, warning);
    ui_.report.device = renderer_.deviceName();
    session_.open(options.files, parseFirstTime(options.time), parseRegion(options.region));
}

void Workbench::takeInput() {
    for (const ui::Chord chord : host_.takeChords()) ui::runChord(ui_, chord);
    if (host_.takeFocus()) session_.lookForGrowth();
    std::vector<std::filesystem::path> files = host_.takeDropped();
    if (files.empty()) return;
    if (files.size() == 1 && isPresetFile(files.front())) {
        session_.loadPreset(files.front().string());
        return;
    }
    std::vector<std::string> names;
    names.reserve(files.size());
    for (const auto& file : files) names.push_back(file.string());
    session_.open(names);
}

void Workbench::takeData() {
    session_.poll();
    try {
        if (const auto volume = session_.takeVolume()) {
            renderer_.setVolume(*volume);
            drawn_.reset();
            changed_ = Clock::now();
        }
    } catch (const Error& error) {
        session_.say(Message::Kind::error, error.message());
    }
}

/// Notices what the panels changed, and makes a step of the history when the hand rests.
void Workbench::noteChanges() {
    const bool moved = session_.document != seen_ || picturePx() != seenPx_;
    if (moved) changed_ = Clock::now();
    seen_ = session_.document;
    seenPx_ = picturePx();
    if (!interacting_ && restS() > kCommitS) session_.history.commit(session_.document);
    if (moved) drawn_.reset();
}

render::FrameInputs Workbench::inputsOf(const ui::Draft& draft) const {
    render::FrameInputs inputs;
    inputs.look = session_.document.look;
    inputs.sizePx = draft.sizePx;
    inputs.sample = draft.sample;
    inputs.draftLight = draft.step == 0;
    inputs.profile = ui_.showProfile;
    if (inputs.look.engine == Engine::slicing) {
        inputs.planes = ui::planesOf(draft, inputs.look.planes);
    } else {
        inputs.look.quality *= static_cast<float>(draft.detail);
    }
    inputs.camera = placeCamera(session_.document.camera, session_.shown()->grid,
                                static_cast<double>(picturePx().x) / picturePx().y);
    return inputs;
}

void Workbench::drawPicture() {
    if (!session_.shown()) return;
    const Engine engine = session_.document.look.engine;
    // A button held still is still motion: the next move must find the machine ready.
    const double rest = interacting_ ? 0.0 : restS();
    const std::optional<ui::Draft> next = ui::nextDraft(
        drawn_, quality_.draft(rest, picturePx(), ui::leastDetailOf(engine)), averages());
    if (!next) return;
    const render::FrameInputs inputs = inputsOf(*next);
    render::FrameStats stats;
    try {
        // A frame in motion is short and always comes through; a refinement gives way to the hand.
        stats = renderer_.render(inputs,
                                 [&](double) { return next->step == 0 || !host_.inputWaits(); });
    } catch (const Cancelled&) {
        return;
    }
    // What the camera does not change is no measure of how finely to draw while it moves.
    const bool prepared = stats.bakedMedium || (engine == Engine::march && stats.marchedLight);
    if (stats.marchedEye && !prepared) quality_.measured(*next, stats.milliseconds, picturePx());
    ui_.report = {stats.milliseconds, engine,       stats.planes,
                  next->sample + 1,   next->sizePx, next->step == ui::kFullStep,
                  ui_.report.device};
    if (inputs.profile) ui::update(ui_.profile, profileOf(stats, inputs, renderer_), !drawn_);
    drawn_ = next;
    for (std::string& message : renderer_.takeMessages()) {
        session_.say(Message::Kind::warning, std::move(message));
    }
}

void Workbench::carryOut() {
    const ui::Requests requests = std::exchange(ui_.requests, {});
    if (requests.toggleFullScreen) host_.toggleFullScreen();
    if (requests.reloadShaders) {
        renderer_.reloadChangedShaders();
        drawn_.reset();
    }
    if (requests.redraw) drawn_.reset();
    if (requests.memory) setMemory(*requests.memory);
    if (requests.quit) host_.close();
}

/// Uses a setting from now on and remembers it.
void Workbench::setMemory(const std::string& memory) {
    try {
        MemoryBudget budget = session_.budget();
        budget.machine = memoryBudget(memory, budget.gpu).machine;
        session_.setBudget(budget);
        ui_.settings.memory = memory;
        saveSettings(ui_.settings);
        session_.say(Message::Kind::note, "Memory: " + memoryText(budget.machine));
    } catch (const Error& error) {
        session_.say(Message::Kind::error, error.message());
    }
}

double Workbench::waitS() const {
    if (session_.shown()) {
        const bool full = drawn_ && drawn_->step == ui::kFullStep;
        if (!drawn_ || (full && averages() && drawn_->sample + 1 < ui::kSamples)) return 0.0;
        if (!full) return kBusyWaitS;
    }
    const bool uncommitted = restS() < 2.0 * kCommitS;
    return session_.loading() || uncommitted ? kBusyWaitS : kIdleWaitS;
}

void Workbench::drawPanels() {
    const auto start = Clock::now();
    host_.beginFrame();
    ui::draw(ui_);
    interacting_ = host_.interacting();
    host_.endFrame(ui::pictureBox(ui_), renderer_.displayTexture(), ui_.report.sizePx);
    quality_.measuredPanels(
        std::chrono::duration<double, std::milli>(Clock::now() - start).count());
}

void Workbench::run() {
    while (!window_.shouldClose()) {
        host_.wait(waitS());
        takeInput();
        takeData();
        drawPicture();
        drawPanels();
        noteChanges();
        carryOut();
    }
}

}  // namespace

int runWorkbench(const SceneOptions& options) {
    Workbench(options).run();
    return 0;
}

}  // namespace neph
