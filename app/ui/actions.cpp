// actions.cpp: the table of actions.
#include "app/ui/actions.h"

#include <algorithm>
#include <array>

#include "app/ui/panels.h"

namespace neph::ui {
namespace {

bool always(const Ui&) {
    return true;
}

int lastTime(const Ui& ui) {
    const DatasetInfo* info = ui.session.info();
    return info == nullptr ? 0 : static_cast<int>(info->times.size()) - 1;
}

bool hasTimes(const Ui& ui) {
    return lastTime(ui) > 0;
}

void goTo(Ui& ui, int time) {
    ui.session.document.time = std::clamp(time, 0, lastTime(ui));
}

const std::array kActions{
    Action{"Camera of the preset",
           {Key::r},
           "R",
           always,
           [](Ui& ui) { ui.session.document.camera = ui.session.homeCamera; }},
    Action{"Undo",
           {Key::z, true},
           "Ctrl+Z",
           [](const Ui& ui) { return ui.session.history.canUndo(); },
           [](Ui& ui) { ui.session.undo(); }},
    Action{"Redo",
           {Key::y, true},
           "Ctrl+Y",
           [](const Ui& ui) { return ui.session.history.canRedo(); },
           [](Ui& ui) { ui.session.redo(); }},
    Action{"Redo",
           {Key::z, true, true},
           "Ctrl+Shift+Z",
           [](const Ui& ui) { return ui.session.history.canRedo(); },
           [](Ui& ui) { ui.session.redo(); }},
    Action{"Save a preset",
           {Key::s, true},
           "Ctrl+S",
           always,
           [](Ui& ui) {
               ui.showPanels = true;
               ui.askForPresetName = true;
           }},
    Action{"Open files", {Key::o, true}, "Ctrl+O", always, [](Ui& ui) { ui.askForPath = true; }},
    Action{"Time before",
           {Key::left},
           "Left",
           hasTimes,
           [](Ui& ui) { goTo(ui, ui.session.document.time - 1); }},
    Action{"Time after",
           {Key::right},
           "Right",
           hasTimes,
           [](Ui& ui) { goTo(ui, ui.session.document.time + 1); }},
    Action{"First time", {Key::home}, "Home", hasTimes, [](Ui& ui) { goTo(ui, 0); }},
    Action{"Last time", {Key::end}, "End", hasTimes, [](Ui& ui) { goTo(ui, lastTime(ui)); }},
    Action{"Follow new times",
           {Key::f},
           "F",
           always,
           [](Ui& ui) { ui.session.follow = !ui.session.follow; }},
    Action{"Around the clouds",
           {Key::c},
           "C",
           [](const Ui& ui) {
               return ui.session.shown() != nullptr && ui.session.shown()->clouds.has_value();
           },
           showAroundClouds},
    Action{"Whole domain",
           {Key::d},
           "D",
           [](const Ui& ui) { return ui.session.region().has_value(); },
           [](Ui& ui) { ui.session.setRegion({}); }},
    Action{"Show or hide the panels",
           {Key::tab},
           "Tab",
           always,
           [](Ui& ui) { ui.showPanels = !ui.showPanels; }},
    Action{"Messages", {Key::m}, "M", always, [](Ui& ui) { ui.showMessages = !ui.showMessages; }},
    Action{"Performance",
           {Key::f3},
           "F3",
           always,
           [](Ui& ui) { ui.requests.redraw = ui.showProfile = !ui.showProfile; }},
    Action{"Full screen",
           {Key::f11},
           "F11",
           always,
           [](Ui& ui) { ui.requests.toggleFullScreen = true; }},
    Action{"Read the shaders again",
           {Key::f5},
           "F5",
           always,
           [](Ui& ui) { ui.requests.reloadShaders = true; }},
    Action{"This help", {Key::h}, "H", always, [](Ui& ui) { ui.showHelp = !ui.showHelp; }},
    Action{"Close help",
           {Key::escape},
           "Esc",
           [](const Ui& ui) { return ui.showHelp; },
           [](Ui& ui) { ui.showHelp = false; }},
    Action{"Quit", {Key::q, true}, "Ctrl+Q", always, [](Ui& ui) { ui.requests.quit = true; }},
};

}  // namespace

std::span<const Action> actions() {
    return kActions;
}

bool runChord(Ui& ui, Chord chord) {
    // A field for text is about to open: what is typed is meant for it.
    if ((ui.askForPath || ui.askForPresetName) && !chord.ctrl) return false;
    const auto found = std::find_if(kActions.begin(), kActions.end(),
                                    [&](const Action& action) { return action.chord == chord; });
    if (found == kActions.end() || !found->enabled(ui)) return false;
    found->run(ui);
    return true;
}

}  // namespace neph::ui
