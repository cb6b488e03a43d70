// preset_browser.h: what the browser of presets keeps between frames, and what it can be told to
// do.
#pragma once
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/base/child_process.h"
#include "core/preset/preset_difference.h"

namespace neph {
class Session;
}

namespace neph::ui {

struct Ui;

/// A preset as it stands in the grid.
struct PresetCard {
    PresetEntry entry;
    Preset preset;
    std::string fault;                ///< why it cannot be read; empty where it can
    std::filesystem::path thumbnail;  ///< where it is once it is made; empty: nowhere
    unsigned texture = 0;             ///< 0: not made or not read yet
};

enum class PresetDialog { saveAs, rename, describe, open };

/// What the last preset changed.
struct PresetApplied {
    std::string name;
    std::string step;  ///< label in the history; empty: none was applied
    std::vector<PresetDifference> rows;
};

struct PresetBrowser {
    std::vector<PresetCard> cards;
    bool listed = false;   ///< false: to be listed anew
    bool revealed = true;  ///< false: the loaded preset is to be scrolled to
    double lookedS = 0.0;  ///< when it was last seen whether files have changed
    std::filesystem::file_time_type stamp{};
    std::string search;
    std::string rested;     ///< the card under the mouse
    double restedS = 0.0;   ///< since when
    PresetApplied applied;  ///< last

    PresetDialog dialog = PresetDialog::saveAs;
    bool openDialog = false;  ///< in the next frame
    std::string subject;      ///< preset that dialog or details are about
    PresetText text;          ///< as typed, as are name and path
    std::string name;
    bool openDetails = false;

    std::unique_ptr<ChildProcess> thumbnails;  ///< makes those that are missing
    bool triedThumbnails = false;              ///< for these cards
};

/// Whether the look is another than that of the preset that was loaded.
bool presetChanged(const Session& session);
/// The document as a preset without words.
Preset presetOf(const Session& session);
/// From preset `name`, or from the present look to it: what would change.
std::vector<PresetDifference> differencesTo(const Session& session, const Preset& preset);

/// Loads parts of it, and keeps in mind what that changed.
void applyPreset(Ui& ui, const std::string& nameOrFile, PresetParts parts = kPresetAll);
/// Under its name where it is the user's own; otherwise asks for one.
void savePreset(Ui& ui);
void openPresetDialog(Ui& ui, PresetDialog dialog, const std::string& subject = {});
/// As JSON, to and from the clipboard.
void copyPreset(Ui& ui, const Preset& preset);
void pastePreset(Ui& ui);

/// Carries out what only touches files: faults become messages, and the list is read again.
void changePresets(Ui& ui, const std::function<std::string()>& change);

}  // namespace neph::ui
