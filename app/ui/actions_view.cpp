// actions_view.cpp: the actions of the View menu.
#include <array>

#include "app/ui/actions.h"
#include "app/ui/panels.h"

namespace neph::ui {
namespace {

const std::array kActions{
    Action{.id = "view.panels",
           .label = "Panels",
           .menu = Menu::view,
           .chord = {Key::tab},
           .help = "Shows or hides all panels",
           .run = [](Ui& ui) { ui.showPanels = !ui.showPanels; },
           .checked = [](const Ui& ui) { return ui.showPanels; }},
    Action{.id = "view.clouds",
           .label = "Around the clouds",
           .menu = Menu::view,
           .chord = {Key::c},
           .help = "Shows the part of the domain that holds the clouds",
           .run = showAroundClouds,
           .enabled =
               [](const Ui& ui) {
                   return ui.session().shown() != nullptr &&
                          ui.session().shown()->clouds.has_value();
               }},
    Action{.id = "view.whole",
           .label = "Whole domain",
           .menu = Menu::view,
           .chord = {Key::d, true},
           .help = "Shows the whole domain again",
           .run = [](Ui& ui) { ui.session().setRegion({}); },
           .enabled = [](const Ui& ui) { return ui.session().region().has_value(); }},
    Action{.id = "view.messages",
           .label = "Messages",
           .menu = Menu::view,
           .chord = {Key::m},
           .help = "The list of all that was said",
           .run = [](Ui& ui) { ui.showMessages = !ui.showMessages; },
           .checked = [](const Ui& ui) { return ui.showMessages; }},
    Action{.id = "view.profile",
           .label = "Performance",
           .menu = Menu::view,
           .chord = {Key::f3},
           .help = "What the picture cost, pass by pass",
           .run = [](Ui& ui) { ui.requests.redraw = ui.showProfile = !ui.showProfile; },
           .checked = [](const Ui& ui) { return ui.showProfile; }},
    Action{.id = "view.full_screen",
           .label = "Full screen",
           .menu = Menu::view,
           .chord = {Key::f11},
           .help = "And back",
           .run = [](Ui& ui) { ui.requests.toggleFullScreen = true; }},
    Action{.id = "view.shaders",
           .label = "Read the shaders again",
           .menu = Menu::view,
           .chord = {Key::f5},
           .help = "After an edit; a fault leaves the last good ones in use",
           .run = [](Ui& ui) { ui.requests.reloadShaders = true; }},
};

}  // namespace

std::span<const Action> viewActions() {
    return kActions;
}

}  // namespace neph::ui
