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
           .help = "Takes the last step back",
           .run = [](Ui& ui) { ui.session().undo(); },
           .enabled = [](const Ui& ui) { return ui.session().history.canUndo(); }},
    Action{.id = "edit.redo",
           .label = "Redo",
           .menu = Menu::edit,
           .chord = {Key::y, true},
           .other = {Key::z, true, true},
           .help = "Does the step again that was undone",
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
           .help = "Field colours after Okabe and Ito, in the image too; and back to table 2",
           .run = toggleColours,
           .checked = isAccessible},
};

}  // namespace

std::span<const Action> editActions() {
    return kActions;
}

}  // namespace neph::ui
