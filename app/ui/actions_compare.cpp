// actions_compare.cpp: the actions of the Compare menu.
#include <array>

#include "app/ui/actions.h"

namespace neph::ui {
namespace {

bool hasSecond(const Ui& ui) {
    return ui.compare.second;
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
           .run =
               [](Ui& ui) {
                   const bool split = ui.compare.mode == CompareMode::split;
                   ui.compare.mode = split ? CompareMode::single : CompareMode::split;
                   if (!ui.compare.second) ui.compare.wanted = 1;
               },
           .checked = [](const Ui& ui) { return ui.compare.mode == CompareMode::split; }},
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
           .help = "Gives up the second slot and its memory",
           .run = [](Ui& ui) { ui.compare.close = true; },
           .enabled = hasSecond,
           .separated = true},
};

}  // namespace

std::span<const Action> compareActions() {
    return kActions;
}

}  // namespace neph::ui
