// preset_commands.cpp: what menu, keys, buttons and cards do with presets.
#include <fmt/format.h>
#include <imgui.h>

#include <utility>

#include "app/ui/presets/preset_browser.h"
#include "app/ui/shell/ui.h"
#include "core/base/error.h"
#include "core/preset/preset_files.h"

namespace neph::ui {
namespace {

/// Remembers what `change` does to the document.
void follow(Ui& ui, const std::string& name, const std::function<bool()>& change) {
    const Preset before = presetOf(ui.session());
    if (!change()) return;
    ui.presets.applied = {name, ui.session().history.undoLabel(),
                          differences(before, presetOf(ui.session()))};
}

}  // namespace

bool presetChanged(const Session& session) {
    return session.document.look != session.presetLook;
}

Preset presetOf(const Session& session) {
    return {"", "", session.document.look, session.document.camera};
}

std::vector<PresetDifference> differencesTo(const Session& session, const Preset& preset) {
    return differences(presetOf(session), preset);
}

void applyPreset(Ui& ui, const std::string& nameOrFile, PresetParts parts) {
    follow(ui, presetLabel(nameOrFile), [&] { return ui.session().loadPreset(nameOrFile, parts); });
}

void savePreset(Ui& ui) {
    const std::string& name = ui.session().presetName;
    if (presetNameUse(name) != PresetNameUse::own) {
        openPresetDialog(ui, PresetDialog::saveAs);
        return;
    }
    ui.session().savePreset(std::string(name), true);
    ui.presets.listed = false;
}

void openPresetDialog(Ui& ui, PresetDialog dialog, const std::string& subject) {
    PresetBrowser& presets = ui.presets;
    presets.dialog = dialog;
    presets.subject = subject;
    presets.openDialog = true;
    presets.text = {};
    presets.name = dialog == PresetDialog::open ? std::string() : subject;
    if (dialog == PresetDialog::saveAs) {
        const std::string name = presetLabel(ui.session().presetName);
        presets.name = freePresetName(name.empty() ? "my look" : name);
    }
    if (dialog != PresetDialog::describe) return;
    try {
        const Preset preset = loadPreset(findPreset(subject)).preset;
        presets.text = {preset.title, preset.description};
    } catch (const Error& error) {
        presets.openDialog = false;
        ui.session().say(Message::Kind::error, error.message());
    }
}

void copyPreset(Ui& ui, const Preset& preset) {
    ImGui::SetClipboardText(formatPreset(preset).c_str());
    ui.session().say(Message::Kind::note, "The clipboard holds the preset as JSON");
}

void pastePreset(Ui& ui) {
    const char* text = ImGui::GetClipboardText();
    try {
        const LoadedPreset loaded = parsePreset(text == nullptr ? "" : text, "clipboard");
        follow(ui, "clipboard", [&] {
            ui.session().takePreset(loaded, kPresetAll, "Preset from the clipboard");
            return true;
        });
    } catch (const Error& error) {
        ui.session().say(Message::Kind::error, error.message());
    }
}

void changePresets(Ui& ui, const std::function<std::string()>& change) {
    try {
        ui.session().say(Message::Kind::note, change());
    } catch (const Error& error) {
        ui.session().say(Message::Kind::error, error.message());
    }
    ui.presets.listed = false;
}

}  // namespace neph::ui
