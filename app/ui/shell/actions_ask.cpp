// actions_ask.cpp: the actions of the Ask menu.
#include <array>

#include "app/ui/shell/actions.h"

namespace neph::ui {
namespace {

bool hasData(const Ui& ui) {
    return ui.session().shown() != nullptr;
}

const std::array kActions{
    Action{.id = "ask.probe",
           .label = "Probe",
           .menu = Menu::ask,
           .chord = {Key::p},
           .help = "Tells what the mouse points at: where cloud begins, what it is made of",
           .run = [](Ui& ui) { ui.ask.probes = !ui.ask.probes; },
           .enabled = hasData,
           .needs = "data",
           .checked = [](const Ui& ui) { return ui.ask.probes; }},
    Action{.id = "ask.pin",
           .label = "Pin it",
           .menu = Menu::ask,
           .chord = {Key::p, false, true},
           .help = "Keeps the place that the mouse points at, with a label, in the session",
           .run = [](Ui& ui) { ui.ask.pin = true; },
           .enabled = hasData,
           .needs = "data"},
    Action{.id = "ask.pins",
           .label = "Pins",
           .menu = Menu::ask,
           .chord = {},
           .help = "The list of what was pinned, with what is there at this time",
           .run = [](Ui& ui) { ui.ask.showPins = !ui.ask.showPins; },
           .enabled = hasData,
           .needs = "data",
           .checked = [](const Ui& ui) { return ui.ask.showPins; }},
    Action{.id = "ask.column",
           .label = "Column",
           .menu = Menu::ask,
           .chord = {Key::t},
           .help = "What is over a place: skew-T log-p with CAPE and CIN, hodograph, hydrometeors",
           .run = [](Ui& ui) { ui.ask.showColumn = !ui.ask.showColumn; },
           .enabled = hasData,
           .needs = "data",
           .checked = [](const Ui& ui) { return ui.ask.showColumn; }},
    Action{.id = "ask.section",
           .label = "Section",
           .menu = Menu::ask,
           .chord = {Key::v},
           .help = "A cut along a line, or at a height, of any quantity",
           .run = [](Ui& ui) { ui.ask.showSection = !ui.ask.showSection; },
           .enabled = hasData,
           .needs = "data",
           .checked = [](const Ui& ui) { return ui.ask.showSection; }},
    Action{.id = "ask.series",
           .label = "Series over time",
           .menu = Menu::ask,
           .chord = {Key::y},
           .help = "Maxima, storm top, base, masses and cover of all times",
           .run = [](Ui& ui) { ui.ask.showSeries = !ui.ask.showSeries; },
           .enabled = hasData,
           .needs = "data",
           .checked = [](const Ui& ui) { return ui.ask.showSeries; }},
};

}  // namespace

std::span<const Action> askActions() {
    return kActions;
}

}  // namespace neph::ui
