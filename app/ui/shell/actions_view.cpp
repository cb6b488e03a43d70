// actions_view.cpp: the actions of the View menu.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/ui/data/data_panel.h"
#include "app/ui/shell/actions.h"
#include "core/look/sun.h"

namespace neph::ui {
namespace {

constexpr std::array kTextScales{0.8f, 0.9f, 1.0f, 1.1f, 1.25f, 1.5f, 1.75f, 2.0f, 2.5f};

void setTextScale(Ui& ui, float scale) {
    ui.settings.textScale = scale;
    ui.requests.restyle = true;
}

/// To the step before or after the one that is nearest now.
void scaleText(Ui& ui, int steps) {
    const auto nearest = std::ranges::min_element(
        kTextScales, {}, [&ui](float scale) { return std::abs(scale - ui.settings.textScale); });
    const auto index = static_cast<int>(nearest - kTextScales.begin()) + steps;
    const int last = static_cast<int>(kTextScales.size()) - 1;
    setTextScale(ui, kTextScales.at(static_cast<std::size_t>(std::clamp(index, 0, last))));
}

bool panelsShown(const Ui& ui) {
    return ui.columns.shown;
}

bool isOpen(const Ui& ui, bool left) {
    const Layout layout = ui.layout();
    return !(left ? layout.left : layout.right).empty();
}

void toggleColumn(Ui& ui, bool left) {
    openColumn(ui.settings, ui.columns, left, !isOpen(ui, left));
}

Look& lookOf(Ui& ui) {
    return ui.session().document.look;
}

const std::array kActions{
    Action{.id = "view.panels",
           .label = "Panels",
           .menu = Menu::view,
           .chord = {Key::tab},
           .help = "Shows or hides all panels",
           .run = [](Ui& ui) { ui.columns.shown = !ui.columns.shown; },
           .checked = panelsShown},
    Action{.id = "view.left",
           .label = "Left column",
           .menu = Menu::view,
           .chord = {Key::f2},
           .help = "Data and fields",
           .run = [](Ui& ui) { toggleColumn(ui, true); },
           .enabled = panelsShown,
           .checked = [](const Ui& ui) { return isOpen(ui, true); }},
    Action{.id = "view.right",
           .label = "Right column",
           .menu = Menu::view,
           .chord = {Key::f4},
           .help = "Presets, camera, light, view and output",
           .run = [](Ui& ui) { toggleColumn(ui, false); },
           .enabled = panelsShown,
           .checked = [](const Ui& ui) { return isOpen(ui, false); }},
    Action{.id = "view.theme",
           .label = "Light theme",
           .menu = Menu::view,
           .chord = {},
           .help = "Switches between light and dark panels",
           .run =
               [](Ui& ui) {
                   const bool light = ui.settings.theme == Theme::light;
                   ui.settings.theme = light ? Theme::dark : Theme::light;
                   ui.requests.restyle = true;
               },
           .checked = [](const Ui& ui) { return ui.settings.theme == Theme::light; },
           .separated = true},
    Action{.id = "view.larger",
           .label = "Larger text",
           .menu = Menu::view,
           .chord = {Key::plus, true},
           .help = "Makes text and panels a step larger",
           .run = [](Ui& ui) { scaleText(ui, 1); },
           .enabled = [](const Ui& ui) { return ui.settings.textScale < kTextScales.back(); }},
    Action{.id = "view.smaller",
           .label = "Smaller text",
           .menu = Menu::view,
           .chord = {Key::minus, true},
           .help = "Makes text and panels a step smaller",
           .run = [](Ui& ui) { scaleText(ui, -1); },
           .enabled = [](const Ui& ui) { return ui.settings.textScale > kTextScales.front(); }},
    Action{.id = "view.text_size",
           .label = "Normal text size",
           .menu = Menu::view,
           .chord = {Key::n0, true},
           .help = "Resets text and panels to the monitor's own size",
           .run = [](Ui& ui) { setTextScale(ui, 1.0f); },
           .enabled = [](const Ui& ui) { return ui.settings.textScale != 1.0f; }},
    Action{.id = "view.clouds",
           .label = "Around the clouds",
           .menu = Menu::view,
           .chord = {Key::c},
           .help = "Shows the part of the domain that holds the clouds",
           .run = [](Ui& ui) { showAroundClouds(ui.session()); },
           .enabled =
               [](const Ui& ui) {
                   return ui.session().shown() != nullptr &&
                          ui.session().shown()->clouds.has_value();
               },
           .separated = true},
    Action{.id = "view.whole",
           .label = "Whole domain",
           .menu = Menu::view,
           .chord = {Key::d, true},
           .help = "Shows the whole domain again",
           .run = [](Ui& ui) { ui.session().setRegion({}); },
           .enabled = [](const Ui& ui) { return ui.session().region().has_value(); }},
    Action{.id = "sun.golden_hour",
           .label = "Golden hour",
           .menu = Menu::view,
           .chord = {},
           .help = "Puts the sun at 6 degrees, where it stands",
           .run = [](Ui& ui) { setGoldenHour(lookOf(ui), ui.session().where()); },
           .separated = true},
    Action{.id = "sun.noon",
           .label = "Noon",
           .menu = Menu::view,
           .chord = {},
           .help = "Puts the sun where it is at noon: by date on the meridian, by angles in the "
                   "south at 60 degrees",
           .run = [](Ui& ui) { setNoon(lookOf(ui), ui.session().where()); }},
    Action{.id = "sun.backlit",
           .label = "Backlit",
           .menu = Menu::view,
           .chord = {},
           .help = "Puts the sun at 10 degrees behind what the camera sees",
           .run = [](Ui& ui) { setBacklit(lookOf(ui), ui.session().document.camera.azimuthDeg); }},
    Action{.id = "view.full_screen",
           .label = "Full screen",
           .menu = Menu::view,
           .chord = {Key::f11},
           .help = "And back",
           .run = [](Ui& ui) { ui.requests.toggleFullScreen = true; },
           .separated = true},
    Action{.id = "view.shaders",
           .label = "Reload shaders",
           .menu = Menu::view,
           .chord = {Key::f5},
           .help = "Recompiles them after an edit; if one fails, the last good one stays in use",
           .run = [](Ui& ui) { ui.requests.reloadShaders = true; }},
};

}  // namespace

std::span<const Action> viewActions() {
    return kActions;
}

}  // namespace neph::ui
