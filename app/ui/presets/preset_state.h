// preset_state.h: what the browser of presets keeps between frames.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/presets/preset_placeholder.h"
#include "core/base/child_process.h"
#include "core/preset/preset_difference.h"

namespace neph::ui {

/// A preset as it stands in the grid.
struct PresetCard {
    PresetEntry entry;
    Preset preset;
    std::string fault;                             ///< why it cannot be read; empty where it can
    std::filesystem::path thumbnail;               ///< where it is once it is made; empty: nowhere
    unsigned texture = 0;                          ///< 0: not made or not read yet
    std::optional<PresetPlaceholder> placeholder;  ///< in its place
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
    bool listed = false;   ///< false: to be listed again
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

}  // namespace neph::ui
