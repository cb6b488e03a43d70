// actions_edit.cpp: the actions of the Edit menu.
#include <array>

#include "app/ui/actions.h"

namespace neph::ui {
namespace {

const std::array kActions{
    Action{.id = "edit.undo",
           .label = "Undo",
           .menu = Menu::edit,
           .chord = {Key::z, true},
           .help = "Takes the last step back",
           .run = [](Ui& ui) { ui.session().undo(); },
           .enabled = [](const Ui& ui) { return ui.session().history.canUndo(); }},
    Action{.id = "edit.redo",
           .label = "Redo",
           .menu = Menu::edit,
           .chord = {Key::y, true},
           .help = "Does the step again that was taken back",
           .run = [](Ui& ui) { ui.session().redo(); },
           .enabled = [](const Ui& ui) { return ui.session().history.canRedo(); }},
};

}  // namespace

std::span<const Action> editActions() {
    return kActions;
}

}  // namespace neph::ui
