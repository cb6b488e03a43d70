// key_table.cpp: rows of the table of actions.
#include "app/ui/shell/key_table.h"

#include <fmt/format.h>

#include "app/ui/shell/actions.h"

namespace neph::ui {
namespace {

/// A '|' would end the cell.
std::string cell(std::string_view text) {
    std::string safe;
    for (const char c : text) safe += c == '|' ? std::string("\\|") : std::string(1, c);
    return safe;
}

std::string chords(const Action& action) {
    const std::string other = chordText(action.other);
    return chordText(action.chord) + (other.empty() ? "" : ", " + other);
}

}  // namespace

std::string keyTable() {
    std::string table = "| menu | command | keys | |\n|---|---|---|---|\n";
    const Action* before = nullptr;
    for (const Action& action : actions()) {
        const bool same = before != nullptr && before->menu == action.menu;
        table += fmt::format("| {} | {} | {} | {} |\n",
                             same ? "" : fmt::format("**{}**", menuName(action.menu)),
                             cell(action.label), cell(chords(action)), cell(action.help));
        before = &action;
    }
    return table;
}

}  // namespace neph::ui
