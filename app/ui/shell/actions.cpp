// actions.cpp: the table of actions, put together from its menus.
#include "app/ui/shell/actions.h"

#include <algorithm>

#include "app/ui/shell/panel_table.h"

namespace neph::ui {
namespace {

Action toggleOf(const Panel& panel) {
    Action action = panel.toggle;
    action.run = [&panel](Ui& ui) {
        ui.*panel.shown = !(ui.*panel.shown);
        if (panel.toggled != nullptr) panel.toggled(ui);
    };
    action.checked = [&panel](const Ui& ui) { return ui.*panel.shown; };
    return action;
}

/// Puts the actions that show and hide panels in their places among the rows of their menus.
void addToggles(std::vector<Action>& rows) {
    for (const Panel& panel : panels()) {
        if (panel.shown == nullptr) continue;
        auto next = std::ranges::find(rows, panel.before, &Action::id);
        if (next == rows.end()) {
            next = std::ranges::find(rows.rbegin(), rows.rend(), panel.toggle.menu, &Action::menu)
                       .base();
        }
        rows.insert(next, toggleOf(panel));
    }
}

}  // namespace

const std::vector<Action>& actions() {
    static const std::vector<Action> all = [] {
        std::vector<Action> rows;
        for (const std::span<const Action> menu :
             {fileActions(), editActions(), viewActions(), presetActions(), cameraActions(),
              timeActions(), askActions(), compareActions(), outputActions(), helpActions()}) {
            rows.insert(rows.end(), menu.begin(), menu.end());
        }
        addToggles(rows);
        return rows;
    }();
    return all;
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

bool runChord(Ui& ui, Chord chord) {
    if (chord.key == Key::none) return false;
    // A field for text is about to open: what is typed is meant for it.
    if ((ui.sessionDialogs.opensBrowser || ui.palette.open) && !chord.ctrl) return false;
    const auto found = std::ranges::find_if(actions(), [chord](const Action& action) {
        return action.chord == chord || action.other == chord;
    });
    if (found == actions().end() || !isEnabled(*found, ui)) return false;
    found->run(ui);
    ui.next.again(0.0);  // however long the next image takes
    return true;
}

}  // namespace neph::ui
