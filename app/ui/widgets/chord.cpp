// chord.cpp: names of keys, and who they are meant for.
#include "app/ui/widgets/chord.h"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace neph::ui {
namespace {

/// In the order of Key.
constexpr std::array<std::string_view, kKeyCount> kKeyNames{
    "",     "A",    "B",   "C",      "D",        "E",   "F",   "G",     "H",     "I",
    "J",    "K",    "L",   "M",      "N",        "O",   "P",   "Q",     "R",     "S",
    "T",    "U",    "V",   "W",      "X",        "Y",   "Z",   "0",     "1",     "2",
    "3",    "4",    "5",   "6",      "7",        "8",   "9",   "Left",  "Right", "Up",
    "Down", "Home", "End", "PageUp", "PageDown", "Esc", "Tab", "Space", "Enter", "Delete",
    "?",    ",",    ".",   "+",      "-",        "F1",  "F2",  "F3",    "F4",    "F5",
    "F6",   "F7",   "F8",  "F9",     "F10",      "F11", "F12"};

}  // namespace

std::string chordText(Chord chord) {
    if (chord.key == Key::none) return {};
    const std::string name(kKeyNames.at(static_cast<std::size_t>(chord.key)));
    return (chord.ctrl ? "Ctrl+" : "") + std::string(chord.shift ? "Shift+" : "") + name;
}

std::optional<Chord> parseChord(std::string_view text) {
    Chord chord;
    const auto take = [&](std::string_view word) {
        if (!text.starts_with(word)) return false;
        text.remove_prefix(word.size());
        return true;
    };
    chord.ctrl = take("Ctrl+");
    chord.shift = take("Shift+");
    const auto found = std::ranges::find(kKeyNames, text);
    if (text.empty() || found == kKeyNames.end()) return {};
    chord.key = static_cast<Key>(found - kKeyNames.begin());
    return chord;
}

bool keyIsTaken(Chord chord) {
    constexpr auto kAny = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
    if (ImGui::IsPopupOpen("", kAny)) return true;
    if (!ImGui::GetIO().WantTextInput) return false;
    // A control chord is a command even there, unless it edits text.
    constexpr std::array kOfText{Key::a, Key::c, Key::v, Key::x, Key::y, Key::z};
    return !chord.ctrl || std::ranges::find(kOfText, chord.key) != kOfText.end();
}

}  // namespace neph::ui
