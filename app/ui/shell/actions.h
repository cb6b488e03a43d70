// actions.h: everything that the program can be told to do, declared once: menus, shortcuts, the
// palette and the cheat sheet read it.
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "app/ui/shell/action.h"

namespace neph::ui {

/// Each in the file of its menu; a menu's order is the order of its rows, with those that show
/// panels where the table of panels puts them.
std::span<const Action> fileActions();
std::span<const Action> editActions();
std::span<const Action> viewActions();
std::span<const Action> presetActions();
std::span<const Action> cameraActions();
std::span<const Action> timeActions();
std::span<const Action> askActions();
std::span<const Action> compareActions();
std::span<const Action> outputActions();
std::span<const Action> helpActions();

/// All of them, menu by menu.
const std::vector<Action>& actions();

/// nullptr when there is none of that id.
const Action* findAction(std::string_view id);
/// Runs it; false when there is none or it is not enabled.
bool runAction(Ui& ui, std::string_view id);
/// Runs the action of a chord; likewise.
bool runChord(Ui& ui, Chord chord);

}  // namespace neph::ui
