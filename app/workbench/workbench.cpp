// workbench.cpp: the loop: input, data, pictures, panels, in that order and only when something
// happens.
#include "app/workbench/workbench.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "app/gl/context.h"
#include "app/image_io/png.h"
#include "app/ui/camera/camera_view.h"
#include "app/ui/output/output_run.h"
#include "app/ui/shell/actions.h"
#include "app/ui/shell/ui.h"
#include "app/ui/widgets/places.h"
#include "app/workbench/picture_textures.h"
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
constexpr double kBusyWaitS = 0.05;  // while data load or the picture waits to be refined
constexpr double kLingerS = 1.0;     // panels are drawn on after the last input: tooltips
constexpr double kPanelsS = 0.022;   // between two turns of the panels while a picture is drawn

/// Of the files that readers take, as they say, without dots.
std::vector<std::string> extensionsOf(const PluginHost& host) {
    std::vector<std::string> extensions;
    for (const auto& reader : host.readers()) {
        std::istringstream words(reader->extensions);
        for (std::string word; words >> word;) {
            extensions.push_back(word.starts_with('.') ? word.substr(1) : word);
        }
    }
    return extensions;
}

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

class Workbench {
  public:
    explicit Workbench(const SceneOptions& options);
    void run();

  private:
    std::unique_ptr<Slot> makeSlot();
    void offerServices();
    void openFirst(const SceneOptions& options);
    void frameFirst();
    void takeInput();
    void open(const std::vector<std::filesystem::path>& files);
    bool drawPictures();
    bool drawPicture(const ShownPicture& shown, std::size_t count);
    void drawPanels();
    double panelsTurn();
    bool giveWay() const;
    void carryOut();
    void keepSession();
    void noteChanges();
    void playScript();
    void setMemory(const std::string& memory);
    void rememberSettings();
    void handOverPictures();
    double waitS();
    /// In motion paths are traced for what is edited alone, and never while other data come.
    bool putOff(const Slot& slot) {
        const bool waits = slot.session.loading() || (moving() && &slot != &slots_.active());
        return waits && slot.converges();
    }
    Session& session() { return slots_.active().session; }
    bool moving() const { return interacting_ || ui_.animates; }

    std::vector<std::string> readers_;
    gl::Window window_{kWidthPx, kHeightPx, "Nephoscope"};
    WorkbenchHost host_{window_};
    PictureTextures textures_;  // that panels asked for
    MemoryBudget budget_;
    ui::Ui ui_;
    Slots slots_;

    Autosave autosave_{userStateDir()};
    std::optional<ScriptPlayer> script_;
    std::filesystem::path shot_;  // to be written of the next frame
    Settings remembered_;
    ui::PixelBox place_;  // of the pictures, as of the last turn of the panels
    Clock::time_point panelsDrawn_, eventful_ = Clock::now();
    bool interacting_ = false;
    bool framesFirst_ = false;  // no camera was asked for: the first data choose it
};

Workbench::Workbench(const SceneOptions& options)
    : readers_(options.readers), slots_(ui_.compare, [this] { return makeSlot(); }) {
    const Scene scene = makeScene(options);
    std::vector<std::string> warnings = scene.warnings;
    ui_.settings = remembered_ = loadSettings(warnings);
    budget_ = chooseBudget(options.memory, rendererBytes(gl::deviceMemory()), warnings);
    ui_.active = &session();
    ui_.output.readers = readers_;
    session().setBudget(budget_);
    session().document = scene.document;
    session().homeCamera = scene.document.camera;
    session().setPreset(scene.presetName);
    session().history.restart(scene.document);
    for (const std::string& warning : warnings) session().say(Message::Kind::warning, warning);
    host_.restyle(ui_.settings);
    offerServices();
    if (!options.script.empty()) {
        script_.emplace(loadScript(options.script),
                        std::filesystem::path(options.script).filename().string());
        ui::wantPlaces(true);
    }
    openFirst(options);
}

void Workbench::openFirst(const SceneOptions& options) {
    ui_.sessionDialogs.autosave = &autosave_;
    ui_.sessionDialogs.offersCrashed = options.files.empty() && !script_;
    if (options.files.size() == 1 && kindOfFile(options.files.front()) == FileKind::session) {
        ui::openSessionFile(ui_, options.files.front());
    } else {
        framesFirst_ = options.preset.empty() && options.camera.empty();
        session().open(options.files, parseFirstTime(options.time), parseRegion(options.region));
    }
}

/// The first data are shown whole, whatever the size of the window, from the preset's side.
void Workbench::frameFirst() {
    if (!framesFirst_ || !session().shown()) return;
    framesFirst_ = false;
    ui::look(ui_, View::fit);
    session().homeCamera = session().document.camera;
    session().history.restart(session().document);
}

std::unique_ptr<Slot> Workbench::makeSlot() {
    PluginHost readers = PluginHost::standard(readers_);
    ui_.sessionDialogs.browser.extensions = extensionsOf(readers);
    auto slot = std::make_unique<Slot>(std::move(readers), &WorkbenchHost::wake);
    slot->session.setBudget(budget_);
    return slot;
}

void Workbench::offerServices() {
    ui_.services.loadPicture = [this](const auto& png) { return textures_.load(png); };
    ui_.services.showPicture = [this](const Image8& image) { return textures_.show(image); };
    ui_.services.dropPicture = [this](unsigned texture) { textures_.drop(texture); };
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
    const std::vector<std::filesystem::path> files = host_.takeDropped();
    if (!files.empty()) open(files);
}

void Workbench::open(const std::vector<std::filesystem::path>& files) {
    std::vector<std::string> names;
    names.reserve(files.size());
    for (const auto& file : files) names.push_back(file.string());
    ui::openFiles(ui_, names);
}

/// What a picture in the making is left for: commands, and another place for it. What changes the
/// document is noticed by the slot.
bool Workbench::giveWay() const {
    const ui::PixelBox now = ui::pictureBox(ui_);
    const bool placed = now.lower == place_.lower && now.upper == place_.upper;
    return host_.commandsWait() || ui_.compare.wanted >= 0 || ui_.compare.close ||
           ui_.compare.trace || !placed;
}

/// From when there is something to see: what was there at first is no change.
void Workbench::keepSession() {
    if (session().shown() != nullptr) autosave_.tick(ui_.services.state, Clock::now());
}

/// Draws the panels where they have waited long enough and there is something for them to see. A
/// picture that takes long lags behind; panels do not.
double Workbench::panelsTurn() {
    keepSession();  // a picture may take longer than an interval
    if (secondsSince(panelsDrawn_) < kPanelsS) return 0.0;
    const auto start = Clock::now();
    if (host_.inputWaits() || ui_.animates) {
        eventful_ = start;
    } else {
        const double everyS = secondsSince(eventful_) < kLingerS ? ui::kLookS : kIdleWaitS;
        if (secondsSince(panelsDrawn_) < std::min(ui_.againS, everyS)) return 0.0;
    }
    drawPanels();
    return 1e3 * secondsSince(start);
}

bool Workbench::drawPicture(const ShownPicture& shown, std::size_t count) {
    DrawRequest request;
    request.placePx = place_.size();
    request.moving = moving();
    request.profile = ui_.showProfile && shown.slot == &slots_.active();
    request.frameMs = 1e3 / ui_.settings.framesPerSecond / static_cast<double>(count);
    request.panels = [this] { return panelsTurn(); };
    // What is edited does not wait for the other one.
    const Slot* edited = shown.slot == &slots_.active() ? nullptr : &slots_.active();
    request.giveWay = [this, edited] {
        return giveWay() || (edited != nullptr && edited->changedSinceLastLook());
    };
    return shown.slot->draw(request, ui_.profile);
}

/// One picture of each slot that is shown; then, when those are whole, of the one that is not, so
/// that it is there at once when it is wanted.
bool Workbench::drawPictures() {
    place_ = ui::pictureBox(ui_);
    const std::vector<ShownPicture> shown = slots_.shown(place_);
    bool drew = false;
    for (const ShownPicture& picture : shown) {
        if (!picture.slot->converges()) drew |= drawPicture(picture, shown.size());
    }
    // Paths take long: whatever else there is to draw comes first.
    const bool others = drew;
    for (const ShownPicture& picture : shown) {
        if (!picture.slot->converges() || others || putOff(*picture.slot)) continue;
        drew |= drawPicture(picture, shown.size());
    }
    const bool alone = ui_.compare.mode == CompareMode::single;
    ui_.report = (alone ? *shown.front().slot : slots_.active()).report;
    const bool whole = std::ranges::all_of(shown, [this](const ShownPicture& picture) {
        return picture.slot->waiting(moving()) == Slot::Waiting::no;
    });
    if (drew || !whole || moving() || shown.size() > 1 || slots_.other() == nullptr) return drew;
    Slot* hidden = shown.front().slot == slots_.other() ? &slots_.active() : slots_.other();
    return drawPicture({hidden, place_}, 1);
}

/// Gives the pictures of both slots to those who tell how far they are apart.
void Workbench::handOverPictures() {
    if (!ui::comparesPictures(ui_.compare)) return;
    const std::vector<Slot*> slots = slots_.all();
    if (slots.size() < 2 || !ui_.errors.wants(slots_.pair(), Clock::now())) return;
    const Slot &a = *slots[0], &b = *slots[1];
    ui_.errors.start({a.linear(), b.linear(), a.halves(), b.halves()}, Clock::now());
    ui_.again(0.0);  // what comes of it is asked for by panels
}

void Workbench::drawPanels() {
    panelsDrawn_ = Clock::now();
    ui::clearPlaces();
    host_.beginFrame();
    ui_.animates = false;
    ui_.againS = std::numeric_limits<double>::infinity();
    ui::draw(ui_);
    interacting_ = host_.interacting();
    Image8 image;
    std::vector<HostPicture> pictures;
    for (const ShownPicture& shown : slots_.shown(ui::pictureBox(ui_))) {
        pictures.push_back(
            {shown.place, shown.slot->texture(), shown.slot->report.sizePx, shown.widthShare});
    }
    const std::filesystem::path shot = std::exchange(shot_, {});
    host_.endFrame(pictures, shot.empty() ? nullptr : &image);
    if (!shot.empty()) writePng(shot, image, {});
    const double each = 1e3 * secondsSince(panelsDrawn_) / static_cast<double>(pictures.size());
    for (Slot* slot : slots_.all()) slot->measuredPanels(each);
}

/// Notices what the panels changed, and makes a step of the history when the hand rests.
void Workbench::noteChanges() {
    slots_.link();
    for (Slot* slot : slots_.all()) slot->noteChanges();
    // A camera that is led by a path is nobody's change.
    if (!ui_.cameraTools.led) {
        session().history.settle(session().document, moving(), slots_.active().restS());
    }
    if (ui_.settings != remembered_) rememberSettings();
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

void Workbench::rememberSettings() {
    remembered_ = ui_.settings;  // a place that cannot be written to is told once
    try {
        saveSettings(remembered_);
    } catch (const Error& error) {
        session().say(Message::Kind::error, error.message());
    }
}

/// The next frame's input from the script, which ends the program when it is over.
void Workbench::playScript() {
    const ScriptWorld world{ui_,
                            host_.sizePx(),
                            [this] {
                                if (ui::exports(ui_) || ui_.errors.busy()) return false;
                                return std::ranges::all_of(slots_.all(), [](const Slot* slot) {
                                    return !slot->session.loading() &&
                                           slot->waiting(false) == Slot::Waiting::no;
                                });
                            },
                            [this](const std::filesystem::path& png) { shot_ = png; },
                            [this](glm::ivec2 size) { host_.resize(size); },
                            [this](const auto& files) { open(files); }};
    if (const std::optional<PlayedInput> input = script_->next(world)) {
        host_.play(*input);
    } else {
        host_.close();
    }
}

double Workbench::waitS() {
    if (ui_.animates || script_) return 0.0;
    const double again = std::max(0.0, ui_.againS - secondsSince(panelsDrawn_));
    double seconds = std::min(again, kIdleWaitS);
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
    drawPanels();  // makes the picture's place known
    while (!window_.shouldClose()) {
        if (host_.wait(waitS())) eventful_ = Clock::now();
        if (script_) playScript();
        takeInput();
        for (Slot* slot : slots_.all()) slot->takeData();
        frameFirst();
        const bool drew = drawPictures();
        handOverPictures();
        // Where nothing happens nothing is drawn; a script's keys are seen frame by frame.
        if (script_ || drew || session().loading() || ui_.animates ||
            secondsSince(panelsDrawn_) >= ui_.againS || secondsSince(eventful_) < kLingerS) {
            drawPanels();
        }
        noteChanges();
        carryOut();
        keepSession();
    }
    autosave_.finish(slots_.state());
}

}  // namespace

int runWorkbench(const SceneOptions& options) {
    Workbench(options).run();
    return 0;
}

}  // namespace neph
