// chord.h: keys with Ctrl and Shift, and their names.
#pragma once
#include <optional>
#include <string>
#include <string_view>

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

/// Whether a key that is pressed now is meant for what is typed into, a menu or a dialog.
bool keyIsTaken(Chord chord);

}  // namespace neph::ui
