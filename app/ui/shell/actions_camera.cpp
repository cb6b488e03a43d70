// actions_camera.cpp: the actions of the Camera menu. W, A, S, D, Q and E are left to flight.
#include <array>

#include "app/ui/camera/camera_view.h"
#include "app/ui/shell/actions.h"

namespace neph::ui {
namespace {

bool hasData(const Ui& ui) {
    return ui.session().shown() != nullptr;
}

void lookFrom(Ui& ui, View view) {
    look(ui.session(), view, aspectOf(ui.layout()));
}

const std::array kActions{
    Action{.id = "camera.home",
           .label = "Camera of the preset",
           .menu = Menu::camera,
           .chord = {Key::r},
           .help = "Moves the camera back to where the preset has it",
           .run = [](Ui& ui) { ui.session().document.camera = ui.session().homeCamera; }},
    Action{.id = "camera.fit",
           .label = "Fit to the image",
           .menu = Menu::camera,
           .chord = {Key::f},
           .help = "All visible cloud in the image, seen from the same direction",
           .run = [](Ui& ui) { lookFrom(ui, View::fit); },
           .enabled = hasData},
    Action{.id = "camera.north",
           .label = "From the north",
           .menu = Menu::camera,
           .chord = {Key::n5},
           .help = "Level, all clouds in the image",
           .run = [](Ui& ui) { lookFrom(ui, View::north); },
           .enabled = hasData,
           .separated = true},
    Action{.id = "camera.east",
           .label = "From the east",
           .menu = Menu::camera,
           .chord = {Key::n6},
           .help = "Level, all clouds in the image",
           .run = [](Ui& ui) { lookFrom(ui, View::east); },
           .enabled = hasData},
    Action{.id = "camera.south",
           .label = "From the south",
           .menu = Menu::camera,
           .chord = {Key::n7},
           .help = "Level, all clouds in the image",
           .run = [](Ui& ui) { lookFrom(ui, View::south); },
           .enabled = hasData},
    Action{.id = "camera.west",
           .label = "From the west",
           .menu = Menu::camera,
           .chord = {Key::n8},
           .help = "Level, all clouds in the image",
           .run = [](Ui& ui) { lookFrom(ui, View::west); },
           .enabled = hasData},
    Action{.id = "camera.plan",
           .label = "Plan",
           .menu = Menu::camera,
           .chord = {Key::n9},
           .help = "From above, north on top, all clouds in the image",
           .run = [](Ui& ui) { lookFrom(ui, View::plan); },
           .enabled = hasData},
    Action{.id = "camera.below",
           .label = "From below",
           .menu = Menu::camera,
           .chord = {Key::n0},
           .help = "Straight up, all clouds in the image; the ground is not seen from there",
           .run = [](Ui& ui) { lookFrom(ui, View::below); },
           .enabled = hasData},
    Action{.id = "camera.observer",
           .label = "From the ground",
           .menu = Menu::camera,
           .chord = {Key::o},
           .help = "As a spotter below the eye sees it; the place is set in the Camera panel",
           .run = [](Ui& ui) { lookFromGround(ui.session(), ui.cameraTools); },
           .enabled = hasData},
    Action{.id = "camera.fly",
           .label = "Fly",
           .menu = Menu::camera,
           .chord = {Key::g},
           .help = "W A S D move the eye, E and Q lift and lower it, a drag looks around, the "
                   "wheel sets the speed, Shift is faster",
           .run = [](Ui& ui) { ui.cameraTools.flying = !ui.cameraTools.flying; },
           .checked = [](const Ui& ui) { return ui.cameraTools.flying; },
           .separated = true},
    Action{.id = "camera.bookmark",
           .label = "Add a bookmark",
           .menu = Menu::camera,
           .chord = {Key::b},
           .help = "Stores this view in the Camera panel and in the session",
           .run = [](Ui& ui) { addBookmark(ui.session()); },
           .separated = true},
    Action{.id = "camera.path_key",
           .label = "Add a key to the path",
           .menu = Menu::camera,
           .chord = {Key::k},
           .help = "The camera path passes here: at its end, or where it stands while it leads",
           .run = [](Ui& ui) { addPathKey(ui.session(), ui.playback); }},
    Action{.id = "camera.scale_bar",
           .label = "Scale bar",
           .menu = Menu::camera,
           .chord = {},
           .help = "A length at the distance of the target, over the image; not in files",
           .run = [](Ui& ui) { ui.settings.scaleBar = !ui.settings.scaleBar; },
           .checked = [](const Ui& ui) { return ui.settings.scaleBar; },
           .separated = true},
    Action{.id = "camera.compass",
           .label = "Compass rose",
           .menu = Menu::camera,
           .chord = {},
           .help = "North and the sun, over the image; not in files",
           .run = [](Ui& ui) { ui.settings.compass = !ui.settings.compass; },
           .checked = [](const Ui& ui) { return ui.settings.compass; }},
    Action{.id = "camera.height_ruler",
           .label = "Height ruler",
           .menu = Menu::camera,
           .chord = {},
           .help = "Heights at the nearest edge of the domain, over the image; not in files",
           .run = [](Ui& ui) { ui.settings.heightRuler = !ui.settings.heightRuler; },
           .checked = [](const Ui& ui) { return ui.settings.heightRuler; }},
};

}  // namespace

std::span<const Action> cameraActions() {
    return kActions;
}

}  // namespace neph::ui
