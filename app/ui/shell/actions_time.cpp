// actions_time.cpp: the actions of the Time menu.
#include <algorithm>
#include <array>

#include "app/ui/shell/actions.h"
#include "app/ui/time/time_bar.h"

namespace neph::ui {
namespace {

constexpr int kManyTimes = 10;

bool hasTimes(const Ui& ui) {
    return lastTime(ui.session()) > 0;
}

bool hasPath(const Ui& ui) {
    return ui.session().document.path.keys.size() > 1;
}

bool hasMembers(const Ui& ui) {
    return ui.session().ensemble() != nullptr;
}

void goTo(Ui& ui, int time) {
    ui.session().document.time = std::clamp(time, 0, lastTime(ui.session()));
}

void goBy(Ui& ui, int times) {
    goTo(ui, ui.session().document.time + times);
}

/// Begins again where the end was reached before.
void play(Ui& ui) {
    Playback& playback = ui.playback;
    playback.playing = !playback.playing;
    playback.sinceS = 0.0;
    playback.from = playback.to = -1;
    if (!playback.playing) return;
    playback.alongPath = hasPath(ui) && (playback.alongPath || !hasTimes(ui));
    if (playback.alongPath) {
        if (playback.atS >= durationS(ui.session().document.path)) playback.atS = 0.0;
    } else if (!playback.loop && ui.session().document.time == lastTime(ui.session())) {
        goTo(ui, 0);
    }
}

const std::array kActions{
    Action{.id = "time.play",
           .label = "Play",
           .menu = Menu::time,
           .chord = {Key::space},
           .help = "Through the times of the data, or along the camera path; again to pause",
           .run = play,
           .enabled = [](const Ui& ui) { return hasTimeBar(ui.session()); },
           .checked = [](const Ui& ui) { return ui.playback.playing; }},
    Action{.id = "time.loop",
           .label = "Loop",
           .menu = Menu::time,
           .chord = {Key::l},
           .help = "Starts again from the beginning at the end",
           .run = [](Ui& ui) { ui.playback.loop = !ui.playback.loop; },
           .checked = [](const Ui& ui) { return ui.playback.loop; }},
    Action{.id = "time.along_path",
           .label = "Along the camera path",
           .menu = Menu::time,
           .chord = {},
           .help = "Playing follows the keys of the camera path, and the times with it if the path "
                   "says so",
           .run = [](Ui& ui) { ui.playback.alongPath = !ui.playback.alongPath; },
           .enabled = hasPath,
           .checked = [](const Ui& ui) { return ui.playback.alongPath; }},
    Action{.id = "time.slower",
           .label = "Slower",
           .menu = Menu::time,
           .chord = {Key::comma},
           .help = "Halves the number of times per second",
           .run = [](Ui& ui) { changeSpeed(ui.playback, -1); },
           .enabled = hasTimes},
    Action{.id = "time.faster",
           .label = "Faster",
           .menu = Menu::time,
           .chord = {Key::period},
           .help = "Doubles the number of times per second",
           .run = [](Ui& ui) { changeSpeed(ui.playback, 1); },
           .enabled = hasTimes},
    Action{.id = "time.before",
           .label = "Time before",
           .menu = Menu::time,
           .chord = {Key::left},
           .help = "Goes back one time",
           .run = [](Ui& ui) { goBy(ui, -1); },
           .enabled = hasTimes,
           .separated = true},
    Action{.id = "time.after",
           .label = "Time after",
           .menu = Menu::time,
           .chord = {Key::right},
           .help = "Goes on one time",
           .run = [](Ui& ui) { goBy(ui, 1); },
           .enabled = hasTimes},
    Action{.id = "time.far_before",
           .label = "Ten times back",
           .menu = Menu::time,
           .chord = {.key = Key::left, .shift = true},
           .help = "Goes back ten times, or to the first",
           .run = [](Ui& ui) { goBy(ui, -kManyTimes); },
           .enabled = hasTimes},
    Action{.id = "time.far_after",
           .label = "Ten times on",
           .menu = Menu::time,
           .chord = {.key = Key::right, .shift = true},
           .help = "Goes on ten times, or to the last",
           .run = [](Ui& ui) { goBy(ui, kManyTimes); },
           .enabled = hasTimes},
    Action{.id = "time.first",
           .label = "First time",
           .menu = Menu::time,
           .chord = {Key::home},
           .help = "Goes to the first time of the series",
           .run = [](Ui& ui) { goTo(ui, 0); },
           .enabled = hasTimes},
    Action{.id = "time.last",
           .label = "Last time",
           .menu = Menu::time,
           .chord = {Key::end},
           .help = "Goes to the last time of the series",
           .run = [](Ui& ui) { goTo(ui, lastTime(ui.session())); },
           .enabled = hasTimes},
    Action{.id = "time.member_before",
           .label = "Member before",
           .menu = Menu::time,
           .chord = {Key::pageUp},
           .help = "Of an ensemble, at the same time",
           .run = [](Ui& ui) { stepMember(ui.session(), -1); },
           .enabled = hasMembers,
           .needs = "an ensemble: File > Open ensemble",
           .separated = true},
    Action{.id = "time.member_after",
           .label = "Member after",
           .menu = Menu::time,
           .chord = {Key::pageDown},
           .help = "Of an ensemble, at the same time",
           .run = [](Ui& ui) { stepMember(ui.session(), 1); },
           .enabled = hasMembers,
           .needs = "an ensemble: File > Open ensemble"},
    Action{.id = "time.mean",
           .label = "Mean of the members",
           .menu = Menu::time,
           .chord = {Key::m, false, true},
           .help = "Smoother than any member; again for the first",
           .run =
               [](Ui& ui) {
                   int& member = ui.session().document.member;
                   member = member == kMeanMember ? 0 : kMeanMember;
               },
           .enabled = hasMembers,
           .needs = "an ensemble: File > Open ensemble",
           .checked = [](const Ui& ui) { return ui.session().document.member == kMeanMember; }},
    Action{.id = "time.follow",
           .label = "Follow new times",
           .menu = Menu::time,
           .chord = {Key::f, true},
           .help = "When the last time is shown, goes on to new ones as they appear",
           .run = [](Ui& ui) { ui.session().follow = !ui.session().follow; },
           .checked = [](const Ui& ui) { return ui.session().follow; },
           .separated = true},
};

}  // namespace

std::span<const Action> timeActions() {
    return kActions;
}

}  // namespace neph::ui
