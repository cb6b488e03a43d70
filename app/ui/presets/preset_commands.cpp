// preset_commands.cpp: what menu, keys, buttons and cards do with presets.
#include "app/ui/presets/preset_commands.h"

#include <fmt/format.h>
#include <imgui.h>

#include <utility>

#include "core/base/error.h"
#include "core/preset/preset_files.h"

namespace neph::ui {
namespace {

/// Remembers what `change` does to the document.
void follow(const Session& session, PresetBrowser& presets, const std::string& name,
            const std::function<bool()>& change) {
    const Preset before = presetOf(session);
    if (!change()) return;
    presets.applied = {name, session.history.undoLabel(), differences(before, presetOf(session))};
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

void applyPreset(Session& session, PresetBrowser& presets, const std::string& nameOrFile,
                 PresetParts parts) {
    follow(session, presets, presetLabel(nameOrFile),
           [&] { return session.loadPreset(nameOrFile, parts); });
}

void savePreset(Session& session, PresetBrowser& presets) {
    const std::string& name = session.presetName;
    if (presetNameUse(name) != PresetNameUse::own) {
        openPresetDialog(session, presets, PresetDialog::saveAs);
        return;
    }
    session.savePreset(std::string(name), true);
    presets.listed = false;
}

void openPresetDialog(Session& session, PresetBrowser& presets, PresetDialog dialog,
                      const std::string& subject) {
    presets.dialog = dialog;
    presets.subject = subject;
    presets.openDialog = true;
    presets.text = {};
    presets.name = dialog == PresetDialog::open ? std::string() : subject;
    if (dialog == PresetDialog::saveAs) {
        const std::string name = presetLabel(session.presetName);
        presets.name = freePresetName(name.empty() ? "my look" : name);
    }
    if (dialog != PresetDialog::describe) return;
    try {
        const Preset preset = loadPreset(findPreset(subject)).preset;
        presets.text = {preset.title, preset.description};
    } catch (const Error& error) {
        presets.openDialog = false;
        session.say(Message::Kind::error, error.message());
    }
}

void copyPreset(Session& session, const Preset& preset) {
    ImGui::SetClipboardText(formatPreset(preset).c_str());
    session.say(Message::Kind::note, "The preset was copied to the clipboard as JSON");
}

void pastePreset(Session& session, PresetBrowser& presets) {
    const char* text = ImGui::GetClipboardText();
    try {
        const LoadedPreset loaded = parsePreset(text == nullptr ? "" : text, "clipboard");
        follow(session, presets, "clipboard", [&] {
            session.takePreset(loaded, kPresetAll, "Preset from the clipboard");
            return true;
        });
    } catch (const Error& error) {
        session.say(Message::Kind::error, error.message());
    }
}

void changePresets(Session& session, PresetBrowser& presets,
                   const std::function<std::string()>& change) {
    try {
        session.say(Message::Kind::note, change());
    } catch (const Error& error) {
        session.say(Message::Kind::error, error.message());
    }
    presets.listed = false;
}

}  // namespace neph::ui
