// actions_edit.cpp: the actions of the Edit menu.
#include <array>

#include "app/ui/shell/actions.h"
#include "core/look/colours.h"

namespace neph::ui {
namespace {

bool isAccessible(const Ui& ui) {
    return hasFieldColours(ui.session().document.look, FieldColours::accessible);
}

void toggleColours(Ui& ui) {
    Session& session = ui.session();
    const bool accessible = isAccessible(ui);
    session.history.commit(session.document);
    setFieldColours(session.document.look,
                    accessible ? FieldColours::table2 : FieldColours::accessible);
    session.history.commit(session.document, accessible ? "Field colours of table 2"
                                                        : "Colour-blind-safe field colours");
}

void showAll(Ui& ui) {
    Session& session = ui.session();
    session.history.commit(session.document);
    for (SpeciesLook& field : session.document.look.species) field.visible = true;
    session.history.commit(session.document, "All fields shown");
}

const std::array kActions{
    Action{.id = "edit.undo",
           .label = "Undo",
           .menu = Menu::edit,
           .chord = {Key::z, true},
           .help = "Undoes the last step",
           .run = [](Ui& ui) { ui.session().undo(); },
           .enabled = [](const Ui& ui) { return ui.session().history.canUndo(); }},
    Action{.id = "edit.redo",
           .label = "Redo",
           .menu = Menu::edit,
           .chord = {Key::y, true},
           .other = {Key::z, true, true},
           .help = "Redoes the step that was undone last",
           .run = [](Ui& ui) { ui.session().redo(); },
           .enabled = [](const Ui& ui) { return ui.session().history.canRedo(); }},
    Action{.id = "edit.show_all",
           .label = "Show all fields",
           .menu = Menu::edit,
           .help = "Makes every field visible",
           .run = showAll,
           .separated = true},
    Action{.id = "edit.accessible_colours",
           .label = "Colour-blind-safe field colours",
           .menu = Menu::edit,
           .help = "Switches to field colours after Okabe and Ito, also in the image, or back to "
                   "those of table 2",
           .run = toggleColours,
           .checked = isAccessible},
};

}  // namespace

std::span<const Action> editActions() {
    return kActions;
}

}  // namespace neph::ui
