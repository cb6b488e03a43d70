// actions_output.cpp: the actions of the Output menu.
#include <array>

#include "app/ui/actions.h"

namespace neph::ui {
namespace {

const std::array kActions{
    Action{.id = "output.export",
           .label = "Export...",
           .menu = Menu::output,
           .chord = {Key::e, true},
           .help = "A picture, a series of pictures or a film",
           .run = [](Ui& ui) { ui.output.open = true; }},
};

}  // namespace

std::span<const Action> outputActions() {
    return kActions;
}

}  // namespace neph::ui
