// actions_camera.cpp: the actions of the Camera menu.
#include <array>

#include "app/ui/actions.h"

namespace neph::ui {
namespace {

const std::array kActions{
    Action{.id = "camera.home",
           .label = "Camera of the preset",
           .menu = Menu::camera,
           .chord = {Key::r},
           .help = "Back to where the preset puts it",
           .run = [](Ui& ui) { ui.session().document.camera = ui.session().homeCamera; }},
};

}  // namespace

std::span<const Action> cameraActions() {
    return kActions;
}

}  // namespace neph::ui
