// actions_output.cpp: the actions of the Output menu.
#include <array>

#include "app/ui/output/output_run.h"
#include "app/ui/shell/actions.h"
#include "app/ui/shell/context.h"

namespace neph::ui {
namespace {

bool isRunning(const Ui& ui) {
    return exports(ui.output);
}

bool canExport(const Ui& ui) {
    return ui.session().shown() != nullptr && !isRunning(ui);
}

const std::array kActions{
    Action{
        .id = "output.export",
        .label = "Export...",
        .menu = Menu::output,
        .chord = {Key::e, true},
        .help = "Exports images of any size, series over time or along the camera path, or videos",
        .run = [](Ui& ui) { ui.output.open = true; }},
    Action{.id = "output.image",
           .label = "Save the image",
           .menu = Menu::output,
           .chord = {Key::f12},
           .help = "Saves the image at the size of the window, otherwise with the settings of the "
                   "last export",
           .run = [](Ui& ui) { exportImage(contextOf(ui), ui.output, exportSceneOf(ui)); },
           .enabled = canExport},
    Action{.id = "output.cancel",
           .label = "Stop the export",
           .menu = Menu::output,
           .help = "Stops the export; finished images are kept",
           .run = [](Ui& ui) { ui.output.job->cancel(); },
           .enabled = isRunning,
           .separated = true},
};

}  // namespace

std::span<const Action> outputActions() {
    return kActions;
}

}  // namespace neph::ui
