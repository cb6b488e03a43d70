// actions.h: everything that a key can do, declared once; shortcuts and the help sheet read it.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "app/ui/ui.h"

namespace neph::ui {

/// Keys by what is printed on them; the workbench maps the window system's.
enum class Key : int {
    none,
    c,
    d,
    f,
    h,
    m,
    o,
    q,
    r,
    s,
    y,
    z,
    left,
    right,
    home,
    end,
    escape,
    tab,
    f3,
    f5,
    f11
};

struct Chord {
    Key key = Key::none;
    bool ctrl = false;
    bool shift = false;
    bool operator==(const Chord&) const = default;
};

struct Action {
    std::string_view label;
    Chord chord;
    std::string_view chordText;
    bool (*enabled)(const Ui&);
    void (*run)(Ui&);
};

std::span<const Action> actions();

/// Runs the action of a chord; false when there is none or it is not enabled.
bool runChord(Ui& ui, Chord chord);

}  // namespace neph::ui
