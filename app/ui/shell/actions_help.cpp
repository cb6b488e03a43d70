// actions_help.cpp: the actions of the Help menu.
#include <array>

#include "app/ui/shell/actions.h"

namespace neph::ui {
namespace {

const std::array kActions{
    Action{.id = "help.commands",
           .label = "Find a command...",
           .menu = Menu::help,
           .chord = {Key::p, true},
           .help = "Finds a command or a parameter by part of its name",
           .run = [](Ui& ui) { ui.palette.open = true; }},
    Action{.id = "help.close",
           .label = "Close what is open",
           .menu = Menu::help,
           .chord = {Key::escape},
           .help = "Closes help, messages or an error",
           .run =
               [](Ui& ui) {
                   ui.showHelp = ui.showMessages = false;
                   if (!ui.session().messages.empty()) {
                       ui.dismissedSerial = ui.session().messages.back().serial;
                   }
               }},
};

}  // namespace

std::span<const Action> helpActions() {
    return kActions;
}

}  // namespace neph::ui
