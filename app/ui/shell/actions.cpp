// actions.cpp: the table of actions, put together from its menus.
#include "app/ui/shell/actions.h"

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

const std::vector<Action>& actions() {
    static const std::vector<Action> all = [] {
        std::vector<Action> rows;
        for (const std::span<const Action> menu :
             {fileActions(), editActions(), viewActions(), presetActions(), cameraActions(),
              timeActions(), compareActions(), outputActions(), helpActions()}) {
            rows.insert(rows.end(), menu.begin(), menu.end());
        }
        return rows;
    }();
    return all;
}

std::string tooltipOf(const Action& action) {
    const std::string chord = chordText(action.chord);
    return std::string(action.label) + ": " + std::string(action.help) +
           (chord.empty() ? "" : "  " + chord);
}

bool isEnabled(const Action& action, const Ui& ui) {
    return action.enabled == nullptr || action.enabled(ui);
}

const Action* findAction(std::string_view id) {
    const auto found = std::ranges::find(actions(), id, &Action::id);
    return found == actions().end() ? nullptr : &*found;
}

bool runAction(Ui& ui, std::string_view id) {
    const Action* action = findAction(id);
    if (action == nullptr || !isEnabled(*action, ui)) return false;
    action->run(ui);
    return true;
}

bool keyIsTaken(Chord chord) {
    constexpr auto kAny = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
    if (ImGui::IsPopupOpen("", kAny)) return true;
    if (!ImGui::GetIO().WantTextInput) return false;
    // A control chord is a command even there, unless it edits text.
    constexpr std::array kOfText{Key::a, Key::c, Key::v, Key::x, Key::y, Key::z};
    return !chord.ctrl || std::ranges::find(kOfText, chord.key) != kOfText.end();
}

bool runChord(Ui& ui, Chord chord) {
    if (chord.key == Key::none) return false;
    // A field for text is about to open: what is typed is meant for it.
    if ((ui.askForPath || ui.palette.open) && !chord.ctrl) return false;
    const auto found = std::ranges::find_if(actions(), [chord](const Action& action) {
        return action.chord == chord || action.other == chord;
    });
    if (found == actions().end() || !isEnabled(*found, ui)) return false;
    found->run(ui);
    ui.again(0.0);  // however long the next picture takes
    return true;
}

}  // namespace neph::ui
