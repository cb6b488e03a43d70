// window_keys.cpp: two tables.
#include "app/workbench/window_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <utility>

namespace neph {
namespace {

constexpr std::array<std::pair<int, ui::Key>, 15> kOthers{{{GLFW_KEY_LEFT, ui::Key::left},
                                                           {GLFW_KEY_RIGHT, ui::Key::right},
                                                           {GLFW_KEY_UP, ui::Key::up},
                                                           {GLFW_KEY_DOWN, ui::Key::down},
                                                           {GLFW_KEY_HOME, ui::Key::home},
                                                           {GLFW_KEY_END, ui::Key::end},
                                                           {GLFW_KEY_PAGE_UP, ui::Key::pageUp},
                                                           {GLFW_KEY_PAGE_DOWN, ui::Key::pageDown},
                                                           {GLFW_KEY_ESCAPE, ui::Key::escape},
                                                           {GLFW_KEY_TAB, ui::Key::tab},
                                                           {GLFW_KEY_SPACE, ui::Key::space},
                                                           {GLFW_KEY_ENTER, ui::Key::enter},
                                                           {GLFW_KEY_DELETE, ui::Key::remove},
                                                           {GLFW_KEY_KP_ADD, ui::Key::plus},
                                                           {GLFW_KEY_KP_SUBTRACT, ui::Key::minus}}};
constexpr std::array<std::pair<char, ui::Key>, 7> kSigns{{{'?', ui::Key::question},
                                                          {'/', ui::Key::question},
                                                          {'=', ui::Key::plus},
                                                          {',', ui::Key::comma},
                                                          {'.', ui::Key::period},
                                                          {'+', ui::Key::plus},
                                                          {'-', ui::Key::minus}}};

/// The key `steps` after `first`, in the order of ui::Key.
ui::Key after(ui::Key first, int steps) {
    return static_cast<ui::Key>(static_cast<int>(first) + steps);
}

}  // namespace

ui::Key keyOf(int key, int scancode) {
    for (const auto& [code, named] : kOthers) {
        if (code == key) return named;
    }
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return after(ui::Key::f1, key - GLFW_KEY_F1);
    // Letters and signs go by what is printed on the key, so that Ctrl+Z is where the layout has
    // it.
    const char* name = glfwGetKeyName(key, scancode);
    if (name == nullptr || name[0] == '\0' || name[1] != '\0') return ui::Key::none;
    const char sign = name[0];
    if (sign >= 'a' && sign <= 'z') return after(ui::Key::a, sign - 'a');
    if (sign >= '0' && sign <= '9') return after(ui::Key::n0, sign - '0');
    for (const auto& [printed, named] : kSigns) {
        if (printed == sign) return named;
    }
    return ui::Key::none;
}

int codeOf(ui::Key key) {
    const int at = static_cast<int>(key);
    const auto among = [at](ui::Key first, ui::Key last) {
        return at >= static_cast<int>(first) && at <= static_cast<int>(last);
    };
    const auto from = [at](int code, ui::Key first) { return code + at - static_cast<int>(first); };
    if (among(ui::Key::a, ui::Key::z)) return from(GLFW_KEY_A, ui::Key::a);
    if (among(ui::Key::n0, ui::Key::n9)) return from(GLFW_KEY_0, ui::Key::n0);
    if (among(ui::Key::f1, ui::Key::f12)) return from(GLFW_KEY_F1, ui::Key::f1);
    for (const auto& [code, named] : kOthers) {
        if (named == key) return code;
    }
    return -1;
}

}  // namespace neph
