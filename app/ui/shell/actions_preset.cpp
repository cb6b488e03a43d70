// actions_preset.cpp: the actions of the Presets menu.
#include <array>

#include "app/ui/presets/preset_commands.h"
#include "app/ui/shell/actions.h"
#include "core/preset/preset_files.h"

namespace neph::ui {
namespace {

void openDialog(Ui& ui, PresetDialog dialog) {
    openPresetDialog(ui.session(), ui.presets, dialog);
}

const std::array kActions{
    Action{.id = "preset.save",
           .label = "Save preset",
           .menu = Menu::presets,
           .chord = {Key::s, true},
           .help = "Saves look and camera under the name of your preset, or asks for a name",
           .run = [](Ui& ui) { savePreset(ui.session(), ui.presets); }},
    Action{.id = "preset.save_as",
           .label = "Save preset as...",
           .menu = Menu::presets,
           .chord = {Key::s, true, true},
           .help = "Saves look and camera as a new preset",
           .run = [](Ui& ui) { openDialog(ui, PresetDialog::saveAs); }},
    Action{.id = "preset.open",
           .label = "Preset from file...",
           .menu = Menu::presets,
           .chord = {},
           .help = "Loads look and camera from a preset file",
           .run = [](Ui& ui) { openDialog(ui, PresetDialog::open); },
           .separated = true},
    Action{.id = "preset.again",
           .label = "Reload preset",
           .menu = Menu::presets,
           .chord = {},
           .help = "Discards the changes made since it was loaded",
           .run =
               [](Ui& ui) {
                   applyPreset(ui.session(), ui.presets, std::string(ui.session().presetName));
               },
           .enabled =
               [](const Ui& ui) {
                   return !ui.session().presetName.empty() && presetChanged(ui.session());
               }},
    Action{.id = "preset.copy",
           .label = "Copy preset",
           .menu = Menu::presets,
           .chord = {Key::c, true, true},
           .help = "Copies look and camera to the clipboard as JSON",
           .run =
               [](Ui& ui) {
                   Preset preset = presetOf(ui.session());
                   preset.title = presetLabel(ui.session().presetName);
                   copyPreset(ui.session(), preset);
               },
           .separated = true},
    Action{.id = "preset.paste",
           .label = "Paste preset",
           .menu = Menu::presets,
           .chord = {Key::v, true, true},
           .help = "Pastes look and camera from JSON in the clipboard",
           .run = [](Ui& ui) { pastePreset(ui.session(), ui.presets); }},
};

}  // namespace

std::span<const Action> presetActions() {
    return kActions;
}

}  // namespace neph::ui
