// actions_compare.cpp: the actions of the Compare menu.
#include <array>

#include "app/ui/shell/actions.h"
#include "app/ui/widgets/reference_text.h"

namespace neph::ui {
namespace {

bool hasSecond(const Ui& ui) {
    return ui.compare.second;
}

/// Turns a way of sharing the image on, or off again.
void toggle(Ui& ui, CompareMode mode) {
    ui.compare.mode = ui.compare.mode == mode ? CompareMode::single : mode;
    if (!ui.compare.second) ui.compare.wanted = 1;
}

bool isMeasurable(const Ui& ui) {
    return !traitsOf(ui.session().document.look.engine).groundTruth;
}

const std::array kActions{
    Action{.id = "compare.a",
           .label = "Slot A",
           .menu = Menu::compare,
           .chord = {Key::n1},
           .help = "Shows and edits the first of two looks, times or data sets",
           .run = [](Ui& ui) { ui.compare.wanted = 0; },
           .checked = [](const Ui& ui) { return ui.compare.active == 0; }},
    Action{.id = "compare.b",
           .label = "Slot B",
           .menu = Menu::compare,
           .chord = {Key::n2},
           .help = "Shows and edits the second; at first a copy of A. Hold Shift to peek at the "
                   "other",
           .run = [](Ui& ui) { ui.compare.wanted = 1; },
           .checked = [](const Ui& ui) { return ui.compare.active == 1; }},
    Action{.id = "compare.split",
           .label = "Side by side",
           .menu = Menu::compare,
           .chord = {Key::n3},
           .help = "A to the left of a line that can be dragged, B to the right of it",
           .run = [](Ui& ui) { toggle(ui, CompareMode::split); },
           .checked = [](const Ui& ui) { return ui.compare.mode == CompareMode::split; }},
    Action{.id = "compare.flicker",
           .label = "Flicker",
           .menu = Menu::compare,
           .chord = {Key::n4},
           .help = "A and B alternately, half a second each: what differs moves",
           .run = [](Ui& ui) { toggle(ui, CompareMode::flicker); },
           .checked = [](const Ui& ui) { return ui.compare.mode == CompareMode::flicker; }},
    Action{.id = "compare.error",
           .label = "Error image",
           .menu = Menu::compare,
           .chord = {Key::x},
           .help = "Where A is darker than B, blue, or brighter, red",
           .run = [](Ui& ui) { toggle(ui, CompareMode::error); },
           .checked = [](const Ui& ui) { return ui.compare.mode == CompareMode::error; }},
    Action{.id = "compare.figures",
           .label = "Figures",
           .menu = Menu::compare,
           .chord = {},
           .help = "How far A is from B: bias, relRMSE, relMSE, p95, FLIP",
           .run = [](Ui& ui) { ui.compare.figures = !ui.compare.figures; },
           .enabled = hasSecond,
           .needs = "slot B",
           .checked = [](const Ui& ui) { return ui.compare.figures; }},
    Action{.id = "compare.reference",
           .label = "Compare with the reference",
           .menu = Menu::compare,
           .chord = {},
           .help = "B becomes what the reference draws of A: side by side, with figures",
           .run = [](Ui& ui) { ui.compare.trace = true; },
           .enabled =
               [](const Ui& ui) {
                   const bool traced = ui.session().document.look.engine == groundTruth();
                   return ui.compare.second || !traced;
               },
           .separated = true},
    Action{.id = "compare.preview",
           .label = kPreviewName,
           .menu = Menu::compare,
           .chord = {Key::n},
           .help =
               "Of the reference, soon smooth and a little off: for looking at, not in files or "
               "figures",
           .run = [](Ui& ui) { ui.settings.denoisedPreview = !ui.settings.denoisedPreview; },
           .enabled = [](const Ui& ui) { return canPreview(ui.previews); },
           .needs = "an image of the reference: View > Engine, or Compare with the reference",
           .checked = [](const Ui& ui) { return ui.settings.denoisedPreview; }},
    Action{.id = "compare.measure",
           .label = "Measure the error",
           .menu = Menu::compare,
           .chord = {},
           .help = "How far this image is from the reference, at low resolution and in the "
                   "background: in the status line",
           .run = [](Ui& ui) { ui.errorMeter.toggled = true; },
           .enabled = isMeasurable,
           .needs = "an engine other than the reference itself",
           .checked = [](const Ui& ui) { return ui.errorMeter.measures; }},
    Action{.id = "compare.measure_at_rest",
           .label = "Measure the error at rest",
           .menu = Menu::compare,
           .chord = {},
           .help = "Of every image, once it is complete and until something changes",
           .run = [](Ui& ui) { ui.settings.measureAtRest = !ui.errorMeter.atRest(ui.settings); },
           .checked = [](const Ui& ui) { return ui.errorMeter.atRest(ui.settings); }},
    Action{.id = "compare.error_map",
           .label = "Error map",
           .menu = Menu::compare,
           .chord = {Key::x, false, true},
           .help = "Where this image is darker than the reference, blue, or brighter, red; not in "
                   "files",
           .run = [](Ui& ui) { ui.errorMeter.map = !ui.errorMeter.map; },
           .enabled =
               [](const Ui& ui) {
                   return ui.compare.mode == CompareMode::single &&
                          (ui.errorMeter.map || isMeasurable(ui));
               },
           .checked = [](const Ui& ui) { return ui.errorMeter.map; }},
    Action{.id = "compare.link_cameras",
           .label = "Link the cameras",
           .menu = Menu::compare,
           .chord = {},
           .help = "Both slots are seen from the same place",
           .run = [](Ui& ui) { ui.compare.linkedCameras = !ui.compare.linkedCameras; },
           .checked = [](const Ui& ui) { return ui.compare.linkedCameras; },
           .separated = true},
    Action{.id = "compare.link_times",
           .label = "Link the times",
           .menu = Menu::compare,
           .chord = {},
           .help = "Stepping through the times of one slot steps the other as far",
           .run = [](Ui& ui) { ui.compare.linkedTimes = !ui.compare.linkedTimes; },
           .checked = [](const Ui& ui) { return ui.compare.linkedTimes; }},
    Action{.id = "compare.close",
           .label = "Close slot B",
           .menu = Menu::compare,
           .chord = {},
           .help = "Closes the second slot and frees its memory",
           .run = [](Ui& ui) { ui.compare.close = true; },
           .enabled = hasSecond,
           .needs = "slot B",
           .separated = true},
};

}  // namespace

std::span<const Action> compareActions() {
    return kActions;
}

}  // namespace neph::ui
