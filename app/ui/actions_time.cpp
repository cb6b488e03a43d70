// actions_time.cpp: the actions of the Time menu.
#include <algorithm>
#include <array>

#include "app/ui/actions.h"

namespace neph::ui {
namespace {

int lastTime(const Ui& ui) {
    const DatasetInfo* info = ui.session().info();
    return info == nullptr ? 0 : static_cast<int>(info->times.size()) - 1;
}

bool hasTimes(const Ui& ui) {
    return lastTime(ui) > 0;
}

void goTo(Ui& ui, int time) {
    ui.session().document.time = std::clamp(time, 0, lastTime(ui));
}

const std::array kActions{
    Action{.id = "time.before",
           .label = "Time before",
           .menu = Menu::time,
           .chord = {Key::left},
           .help = "One time back",
           .run = [](Ui& ui) { goTo(ui, ui.session().document.time - 1); },
           .enabled = hasTimes},
    Action{.id = "time.after",
           .label = "Time after",
           .menu = Menu::time,
           .chord = {Key::right},
           .help = "One time on",
           .run = [](Ui& ui) { goTo(ui, ui.session().document.time + 1); },
           .enabled = hasTimes},
    Action{.id = "time.first",
           .label = "First time",
           .menu = Menu::time,
           .chord = {Key::home},
           .help = "The first of the series",
           .run = [](Ui& ui) { goTo(ui, 0); },
           .enabled = hasTimes},
    Action{.id = "time.last",
           .label = "Last time",
           .menu = Menu::time,
           .chord = {Key::end},
           .help = "The last of the series",
           .run = [](Ui& ui) { goTo(ui, lastTime(ui)); },
           .enabled = hasTimes},
    Action{.id = "time.follow",
           .label = "Follow new times",
           .menu = Menu::time,
           .chord = {Key::f, true},
           .help = "From the last time to a new last one as soon as there is one",
           .run = [](Ui& ui) { ui.session().follow = !ui.session().follow; },
           .checked = [](const Ui& ui) { return ui.session().follow; }},
};

}  // namespace

std::span<const Action> timeActions() {
    return kActions;
}

}  // namespace neph::ui
