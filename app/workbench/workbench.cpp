// workbench.cpp: the loop: input, data, images, panels, in that order and only when something
// happens.
#include "app/workbench/workbench.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "app/cli/common/interrupt.h"
#include "app/gl/context.h"
#include "app/image_io/png.h"
#include "app/ui/camera/camera_view.h"
#include "app/ui/output/output_run.h"
#include "app/ui/shell/actions.h"
#include "app/ui/shell/context.h"
#include "app/ui/shell/frame.h"
#include "app/ui/shell/wishes.h"
#include "app/ui/widgets/places.h"
#include "app/workbench/image_textures.h"
#include "app/workbench/kept_settings.h"
#include "app/workbench/measure_error.h"
#include "app/workbench/save_plots.h"
#include "app/workbench/script_player.h"
#include "app/workbench/slots.h"
#include "app/workbench/workbench_host.h"
#include "core/base/resources.h"
#include "core/plugin/plugin_host.h"
#include "core/session/autosave.h"
#include "core/session/file_kind.h"
#include "core/volume/memory_setting.h"

namespace neph {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWidthPx = 1280, kHeightPx = 720;
constexpr double kIdleWaitS = 1.0;   // between looks while nothing happens
constexpr double kBusyWaitS = 0.05;  // while data load or the image waits to be refined
constexpr double kLingerS = 1.0;     // panels are drawn on after the last input: tooltips
constexpr double kPanelsS = 0.022;   // between two turns of the panels while an image is drawn

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

class Workbench {
  public:
    explicit Workbench(const WorkbenchRequest& request);
    void run();

  private:
    std::unique_ptr<Slot> makeSlot();
    void offerServices();
    void openFirst(const SceneRequest& request, bool cameraAsked);
    void takeInput();
    void open(const std::vector<std::filesystem::path>& files);
    bool drawImages();
    bool drawImage(const ShownImage& shown, std::size_t count);
    bool updatePreviews();
    void drawPanels();
    double panelsTurn();
    bool yields() const;
    void carryOut();
    void keepSession();
    void noteChanges();
    void playScript();
    void setMemory(const std::string& memory);
    void handOverImages();
    double waitS();
    /// In motion paths are traced for what is edited alone, and never while other data come.
    bool putOff(const Slot& slot) {
        const bool waits = slot.session.loading() || (moving() && &slot != &slots_.active());
        return waits && slot.converges();
    }
    Session& session() { return slots_.active().session; }
    bool moving() const { return interacting_ || ui_.next.animates; }

    std::vector<std::string> readers_;
    std::string map_;
    KeptSettings kept_;
    gl::Window window_{kWidthPx, kHeightPx, "Nephoscope"};
    WorkbenchHost host_;
    ImageTextures textures_;  // that panels asked for
    MemoryBudget budget_;
    ui::Ui ui_;
    Slots slots_;

    Autosave autosave_{userStateDir()};
    std::optional<ScriptPlayer> script_;
    std::filesystem::path shot_;  // to be written of the next frame
    PixelBox place_;              // of the images, as of the last turn of the panels
    Clock::time_point panelsDrawn_, eventful_ = Clock::now();
    bool interacting_ = false;
    bool measuring_ = false;  // the error of what is seen, at once
};

Workbench::Workbench(const WorkbenchRequest& request)
    : readers_(request.scene.readers),
      map_(request.scene.map),
      // A script plays in the same window everywhere.
      host_(window_, request.script.empty() ? kept_.get().window : std::nullopt),
      slots_(ui_.compare, [this] { return makeSlot(); }) {
    const Scene scene = makeScene(request.scene);
    std::vector<std::string> warnings = scene.warnings;
    std::ranges::copy(kept_.warnings(), std::back_inserter(warnings));
    ui_.settings = kept_.get();
    budget_ = chooseBudget(request.scene.memory, rendererBytes(gl::deviceMemory()), warnings);
    ui_.active = &session();
    ui_.output.readers = readers_;
    session().setBudget(budget_);
    session().document = scene.document;
    session().homeCamera = scene.document.camera;
    session().takeMetres(scene.inMetres);
    session().setPreset(scene.presetName);
    session().history.restart(scene.document);
    for (const std::string& warning : warnings) session().say(Message::Kind::warning, warning);
    host_.restyle(ui_.settings);
    offerServices();
    ui_.errorMeter.atRestByDefault = !gl::deviceMemory().software;
    if (!request.script.empty()) {
        script_.emplace(loadScript(request.script),
                        std::filesystem::path(request.script).filename().string());
        ui::wantPlaces(true);
    }
    ui_.hintsAtKeys = kept_.firstRun() && !script_;
    openFirst(request.scene, scene.cameraAsked);
}

void Workbench::openFirst(const SceneRequest& request, bool cameraAsked) {
    ui_.sessionDialogs.autosave = &autosave_;
    ui_.sessionDialogs.offersCrashed = request.files.empty() && request.members.empty() && !script_;
    if (request.files.size() == 1 && kindOfFile(request.files.front()) == FileKind::session) {
        ui::openSessionFile(ui::contextOf(ui_), ui_.sessionDialogs, request.files.front());
    } else {
        const auto time = request.times ? std::optional(request.times->first) : std::nullopt;
        const bool members = !request.members.empty();
        session().openAs({.named = members ? request.members : request.files,
                          .members = members,
                          .time = time,
                          .memberName = request.member,
                          .region = request.region,
                          .keepsView = cameraAsked});
    }
}

std::unique_ptr<Slot> Workbench::makeSlot() {
    PluginHost readers = PluginHost::standard(readers_, map_);
    ui_.sessionDialogs.browser.extensions = readers.extensions();
    auto slot = std::make_unique<Slot>(std::move(readers), &WorkbenchHost::wake);
    slot->session.setBudget(budget_);
    return slot;
}

void Workbench::offerServices() {
    ui_.services.loadImage = [this](const auto& png) { return textures_.load(png); };
    ui_.services.showImage = [this](const Image8& image) { return textures_.show(image); };
    ui_.services.dropImage = [this](unsigned texture) { textures_.drop(texture); };
    ui_.services.savePlots = [this](const auto& name, const auto& figures, const auto& table) {
        const std::filesystem::path out(ui_.output.settings.file);
        return savePlots(out.parent_path(), name, figures, table, session().info());
    };
    ui_.services.state = [this] { return slots_.state(); };
    ui_.services.restore = [this](const SessionState& state) {
        slots_.restore(state);
        ui_.active = &session();
    };
}

void Workbench::takeInput() {
    for (const ui::Chord chord : host_.takeChords()) ui::runChord(ui_, chord);
    if (host_.takeFocus()) {
        for (Slot* slot : slots_.all()) slot->session.lookForGrowth();
    }
    if (const auto files = host_.takeDropped(); !files.empty()) open(files);
}

void Workbench::open(const std::vector<std::filesystem::path>& files) {
    ui::openFiles(ui_, std::vector<std::string>(files.begin(), files.end()));
}

/// What an image in the making is left for: commands, and another place for it. What changes the
/// document is noticed by the slot.
bool Workbench::yields() const {
    const bool placed = ui::imageBox(ui_.layout()) == place_;
    return host_.commandsWait() || interruptSignal() != 0 || ui_.compare.wanted >= 0 ||
           ui_.compare.close || ui_.compare.trace || !placed;
}

/// From when there is something to see: what was there at first is no change.
void Workbench::keepSession() {
    if (session().shown() != nullptr) autosave_.tick(ui_.services.state, Clock::now());
}

/// Draws the panels where they have waited long enough and there is something for them to see. A
/// image that takes long lags behind; panels do not.
double Workbench::panelsTurn() {
    keepSession();  // an image may take longer than an interval
    if (secondsSince(panelsDrawn_) < kPanelsS) return 0.0;
    const auto start = Clock::now();
    if (updatePreviews() || host_.inputWaits() || ui_.next.animates) {
        eventful_ = start;
    } else {
        const double everyS = secondsSince(eventful_) < kLingerS ? ui::kLookS : kIdleWaitS;
        if (secondsSince(panelsDrawn_) < std::min(ui_.next.againS, everyS)) return 0.0;
    }
    drawPanels();
    return 1e3 * secondsSince(start);
}

bool Workbench::drawImage(const ShownImage& shown, std::size_t count) {
    DrawRequest request;
    request.placePx = place_.size();
    request.moving = moving();
    request.preview = ui_.settings.denoisedPreview;
    request.profile = ui_.showProfile && shown.slot == &slots_.active();
    request.frameMs = 1e3 / ui_.settings.framesPerSecond / static_cast<double>(count);
    request.panels = [this] { return panelsTurn(); };
    // What is edited does not wait for the other one.
    const Slot* edited = shown.slot == &slots_.active() ? nullptr : &slots_.active();
    request.yields = [this, edited] {
        return yields() || (edited != nullptr && edited->changedSinceLastLook());
    };
    return shown.slot->draw(request, ui_.profile);
}

/// Of what is drawn, and then of what is said of it.
bool Workbench::updatePreviews() {
    const bool changed = slots_.updatePreviews(ui_.settings.denoisedPreview, ui_.previews);
    ui_.report = slots_.seen().report;
    ui_.report.measuring = slots_.seen().measures();
    return changed;
}

/// One image of each slot that is shown; then, when those are whole, of the one that is not, so
/// that it is there at once when it is wanted.
bool Workbench::drawImages() {
    place_ = ui::imageBox(ui_.layout());
    const std::vector<ShownImage> shown = slots_.shown(place_);
    bool drew = false;
    for (const ShownImage& image : shown) {
        if (!image.slot->converges()) drew |= drawImage(image, shown.size());
    }
    // Paths take long: whatever else there is to draw comes first.
    const bool others = drew;
    for (const ShownImage& image : shown) {
        if (!image.slot->converges() || others || putOff(*image.slot)) continue;
        drew |= drawImage(image, shown.size());
    }
    drew |= updatePreviews();
    const bool whole = std::ranges::all_of(shown, [this](const ShownImage& image) {
        return image.slot->waiting(moving()) == Slot::Waiting::no;
    });
    if (drew || !whole || moving() || shown.size() > 1 || slots_.other() == nullptr) return drew;
    Slot* hidden = shown.front().slot == slots_.other() ? &slots_.active() : slots_.other();
    return drawImage({hidden, place_}, 1);
}

/// Gives the images of both slots to those who tell how far they are apart.
void Workbench::handOverImages() {
    if (!ui::comparesImages(ui_.compare)) return;
    const std::vector<Slot*> slots = slots_.all();
    if (slots.size() < 2 || !ui_.errors.wants(slots_.pair(), Clock::now())) return;
    const Slot &a = *slots[0], &b = *slots[1];
    ui_.errors.start({a.linear(), b.linear(), a.halves(), b.halves()}, Clock::now());
    ui_.next.again(0.0);  // what comes of it is asked for by panels
}

void Workbench::drawPanels() {
    panelsDrawn_ = Clock::now();
    ui::clearPlaces();
    host_.beginFrame();
    ui_.next = {};
    ui::draw(ui_);
    interacting_ = host_.interacting();
    Image8 image;
    std::vector<HostImage> images;
    for (const ShownImage& shown : slots_.shown(ui::imageBox(ui_.layout()))) {
        images.push_back(
            {shown.place, shown.slot->texture(), shown.slot->textureSizePx(), shown.widthShare});
    }
    const std::filesystem::path shot = std::exchange(shot_, {});
    host_.endFrame(images, shot.empty() ? nullptr : &image);
    if (!shot.empty()) writePng(shot, image, {});
    const double each = 1e3 * secondsSince(panelsDrawn_) / static_cast<double>(images.size());
    for (Slot* slot : slots_.all()) slot->measuredPanels(each);
}

/// Notices what the panels changed, and makes a step of the history when the user rests.
void Workbench::noteChanges() {
    slots_.link();
    for (Slot* slot : slots_.all()) slot->noteChanges();
    // A camera that is led by a path is nobody's change.
    if (!ui_.playback.led) {
        session().history.settle(session().document, moving(), slots_.active().restS());
    }
    if (!interacting_) kept_.keep(ui_.settings, session());
}

void Workbench::carryOut() {
    const ui::Requests requests = std::exchange(ui_.requests, {});
    if (requests.toggleFullScreen) host_.toggleFullScreen();
    if (requests.restyle) host_.restyle(ui_.settings);
    if (requests.memory) setMemory(*requests.memory);
    for (Slot* slot : slots_.all()) {
        if (requests.reloadShaders) slot->reloadShaders();
        if (requests.redraw) slot->redraw();
    }
    slots_.carryOut();
    ui_.active = &session();
    if (requests.quit) host_.close();
}

/// Uses a setting from now on and remembers it.
void Workbench::setMemory(const std::string& memory) {
    try {
        budget_.machine = memoryBudget(memory, budget_.gpu).machine;
        for (Slot* slot : slots_.all()) slot->session.setBudget(budget_);
        ui_.settings.memory = memory;
        session().say(Message::Kind::note, "Memory: " + memoryText(budget_.machine));
    } catch (const Error& error) {
        session().say(Message::Kind::error, error.message());
    }
}

/// The next frame's input from the script, which ends the program when it is over.
void Workbench::playScript() {
    const ScriptWorld world{
        ui_,
        host_.sizePx(),
        [this] { return !ui::exports(ui_.output) && !ui_.errors.busy() && slots_.rest(); },
        [this](const std::filesystem::path& png) { shot_ = png; },
        [this](glm::ivec2 size) { host_.resize(size); },
        [this](const auto& files) { open(files); }};
    if (const std::optional<PlayedInput> input = script_->next(world)) {
        host_.play(*input);
    } else {
        ui_.output.mayQuit = true;
        host_.close();
    }
}

double Workbench::waitS() {
    if (ui_.next.animates || script_ || measuring_) return 0.0;
    double seconds = std::clamp(ui_.next.againS - secondsSince(panelsDrawn_), 0.0, kIdleWaitS);
    for (Slot* slot : slots_.all()) {
        const Slot::Waiting waiting = putOff(*slot) ? Slot::Waiting::rest : slot->waiting(moving());
        if (waiting == Slot::Waiting::now) return 0.0;
        const bool uncommitted = slot->restS() < 2.0 * History::kRestS;
        if (waiting == Slot::Waiting::rest || uncommitted || slot->session.loading()) {
            seconds = std::min(seconds, kBusyWaitS);
        }
    }
    return secondsSince(eventful_) < kLingerS ? std::min(seconds, kBusyWaitS) : seconds;
}

void Workbench::run() {
    drawPanels();  // makes the image's place known
    // A signal to end is a wish to quit: the session is kept. An export that runs is asked about.
    while (interruptSignal() == 0 && !(host_.takeClose() && ui::mayQuit(ui_.output))) {
        if (host_.wait(waitS())) eventful_ = Clock::now();
        if (script_) playScript();
        takeInput();
        for (Slot* slot : slots_.all()) {
            slot->takeData();
            ui::frameOpened(slot->session, ui::aspectOf(ui_.layout()));
        }
        const bool drew = drawImages();
        measuring_ = measureError(ui_, slots_, !drew && !moving(),
                                  [this] { return (!script_ && host_.inputWaits()) || yields(); });
        handOverImages();
        // Where nothing happens nothing is drawn; a script's keys are seen frame by frame.
        if (script_ || drew || session().loading() || ui_.next.animates ||
            secondsSince(panelsDrawn_) >= ui_.next.againS || secondsSince(eventful_) < kLingerS) {
            drawPanels();
        }
        noteChanges();
        carryOut();
        keepSession();
    }
    autosave_.finish(slots_.state());
    if (!script_) ui_.settings.window = host_.place();
    kept_.keep(ui_.settings, session());
}

}  // namespace

int runWorkbench(const WorkbenchRequest& request) {
    noteInterrupts();
    Workbench(request).run();
    return 0;
}

}  // namespace neph
