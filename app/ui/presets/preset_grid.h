// preset_grid.h: what the files of the presets panel have of one another.
#pragma once
#include <vector>

#include "app/ui/presets/preset_card.h"

namespace neph::ui {

/// Reads pictures that are there, has those made that are missing. Once a frame while they show.
void updateThumbnails(Ui& ui);

/// Hands the pictures of the present cards to new ones of the same content, and drops the others.
void keepThumbnails(Ui& ui, std::vector<PresetCard>& cards);

}  // namespace neph::ui
