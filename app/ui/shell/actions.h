// actions.h: everything that the program can be told to do, declared once: menus, shortcuts, the
// palette and the cheat sheet read it.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/shell/ui.h"

namespace neph::ui {

/// Keys by what is printed on them; the workbench maps the window system's.
enum class Key : int {
    none,
    a,
    b,
    c,
    d,
    e,
    f,
    g,
    h,
    i,
    j,
    k,
    l,
    m,
    n,
    o,
    p,
    q,
    r,
    s,
    t,
    u,
    v,
    w,
    x,
    y,
    z,
    n0,
    n1,
    n2,
    n3,
    n4,
    n5,
    n6,
    n7,
    n8,
    n9,
    left,
    right,
    up,
    down,
    home,
    end,
    pageUp,
    pageDown,
    escape,
    tab,
    space,
    enter,
    remove,
    question,
    comma,
    period,
    plus,
    minus,
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    f8,
    f9,
    f10,
    f11,
    f12
};

inline constexpr int kKeyCount = static_cast<int>(Key::f12) + 1;

struct Chord {
    Key key = Key::none;
    bool ctrl = false;
    bool shift = false;
    bool operator==(const Chord&) const = default;
};

/// "Ctrl+Shift+S"; empty for none.
std::string chordText(Chord chord);
/// Reads such a text; none where it is none.
std::optional<Chord> parseChord(std::string_view text);

enum class Menu : int { file, edit, view, presets, camera, time, compare, output, help };
inline constexpr int kMenuCount = 9;
std::string_view menuName(Menu menu);

struct Action {
    std::string_view id;     ///< "file.open"
    std::string_view label;  ///< "Open data..."
    Menu menu = Menu::file;
    Chord chord = {};
    Chord other = {};       ///< does the same; none of most
    std::string_view help;  ///< one line
    void (*run)(Ui&) = nullptr;
    bool (*enabled)(const Ui&) = nullptr;  ///< nullptr: always
    bool (*checked)(const Ui&) = nullptr;  ///< of a switch; nullptr: none
    bool separated = false;                ///< a line above it in its menu
};

/// Each in the file of its menu; a menu's order is the order of its rows.
std::span<const Action> fileActions();
std::span<const Action> editActions();
std::span<const Action> viewActions();
std::span<const Action> presetActions();
std::span<const Action> cameraActions();
std::span<const Action> timeActions();
std::span<const Action> compareActions();
std::span<const Action> outputActions();
std::span<const Action> helpActions();

/// All of them, menu by menu.
const std::vector<Action>& actions();

/// Label, help and chord: "Undo: Takes the last step back  Ctrl+Z".
std::string tooltipOf(const Action& action);
bool isEnabled(const Action& action, const Ui& ui);
/// nullptr when there is none of that id.
const Action* findAction(std::string_view id);
/// Runs it; false when there is none or it is not enabled.
bool runAction(Ui& ui, std::string_view id);
/// Whether a key that is pressed now is meant for what is typed into, a menu or a dialog.
bool keyIsTaken(Chord chord);
/// Runs the action of a chord; likewise.
bool runChord(Ui& ui, Chord chord);

}  // namespace neph::ui
