// context.cpp: references into Ui, and the table of actions behind a lookup.
#include "app/ui/shell/context.h"

#include <cassert>

#include "app/ui/shell/actions.h"

namespace neph::ui {
namespace {

ActionFace faceOf(const Ui& ui, std::string_view id) {
    const Action* action = findAction(id);
    assert(action != nullptr);
    return {tooltipOf(*action), isEnabled(*action, ui), isChecked(*action, ui)};
}

}  // namespace

PanelContext contextOf(Ui& ui) {
    return {.active = ui.active,
            .settings = ui.settings,
            .services = ui.services,
            .requests = ui.requests,
            .next = ui.next,
            .columns = ui.columns,
            .actions = {.face = [&ui](std::string_view id) { return faceOf(ui, id); },
                        .run = [&ui](std::string_view id) { runAction(ui, id); }}};
}

ExportScene exportSceneOf(const Ui& ui) {
    return {imageBox(ui.layout()).size(), ui.compare.active + 1,
            ui.compare.second && ui.compare.mode == CompareMode::split, ui.output.readers,
            traitsOf(ui.session().document.look.engine).refinement == Refinement::averages};
}

int imageTimeOf(const Ui& ui) {
    const bool alone = ui.compare.mode == CompareMode::single && !ui.compare.peeking;
    return alone ? ui.report.time : -1;
}

}  // namespace neph::ui
