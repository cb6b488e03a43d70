// action.h: one thing that the program can be told to do.
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "app/ui/shell/ui.h"
#include "app/ui/widgets/chord.h"

namespace neph::ui {

enum class Menu : int { file, edit, view, presets, camera, time, ask, compare, output, help };
inline constexpr int kMenuCount = 10;
std::string_view menuName(Menu menu);

struct Action {
    std::string_view id = {};     ///< "file.open"
    std::string_view label = {};  ///< "Open data..."
    Menu menu = Menu::file;
    Chord chord = {};
    Chord other = {};            ///< does the same; none of most
    std::string_view help = {};  ///< one line
    std::function<void(Ui&)> run = {};
    std::function<bool(const Ui&)> enabled = {};  ///< none: always
    std::string_view needs = {};                  ///< what it takes to be enabled; said where not
    std::function<bool(const Ui&)> checked = {};  ///< of a switch; else none
    bool separated = false;                       ///< a line above it in its menu
};

/// Label, help and chord: "Undo: Takes the last step back  Ctrl+Z".
std::string tooltipOf(const Action& action);
/// Help, and what it takes where it is not enabled.
std::string helpOf(const Action& action, const Ui& ui);
bool isEnabled(const Action& action, const Ui& ui);
/// Whether it is a switch that is on.
bool isChecked(const Action& action, const Ui& ui);

}  // namespace neph::ui
