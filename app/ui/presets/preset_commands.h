// preset_commands.h: what the browser of presets can be told to do, by menu, keys, buttons and
// cards.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/ui/presets/preset_state.h"
#include "core/session/session.h"

namespace neph::ui {

/// Whether the look is another than that of the preset that was loaded.
bool presetChanged(const Session& session);
/// The document as a preset without words.
Preset presetOf(const Session& session);
/// From preset `name`, or from the present look to it: what would change.
std::vector<PresetDifference> differencesTo(const Session& session, const Preset& preset);

/// Loads parts of it, and keeps in mind what that changed.
void applyPreset(Session& session, PresetBrowser& presets, const std::string& nameOrFile,
                 PresetParts parts = kPresetAll);
/// Under its name where it is the user's own; otherwise asks for one.
void savePreset(Session& session, PresetBrowser& presets);
void openPresetDialog(Session& session, PresetBrowser& presets, PresetDialog dialog,
                      const std::string& subject = {});
/// As JSON, to and from the clipboard.
void copyPreset(Session& session, const Preset& preset);
void pastePreset(Session& session, PresetBrowser& presets);

/// Carries out what only touches files: faults become messages, and the list is read again.
void changePresets(Session& session, PresetBrowser& presets,
                   const std::function<std::string()>& change);

}  // namespace neph::ui
