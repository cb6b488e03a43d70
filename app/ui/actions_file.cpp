// actions_file.cpp: the actions of the File menu.
#include <array>

#include "app/ui/actions.h"

namespace neph::ui {
namespace {

const std::array kActions{
    Action{.id = "file.open",
           .label = "Open data...",
           .menu = Menu::file,
           .chord = {Key::o, true},
           .help = "Files of one series, or a folder",
           .run = [](Ui& ui) { ui.askForPath = true; }},
    Action{.id = "file.quit",
           .label = "Quit",
           .menu = Menu::file,
           .chord = {Key::q, true},
           .help = "The session is kept",
           .run = [](Ui& ui) { ui.requests.quit = true; },
           .separated = true},
};

}  // namespace

std::span<const Action> fileActions() {
    return kActions;
}

}  // namespace neph::ui
