// preset_thumbnails.h: the images on the cards.
#pragma once
#include <vector>

#include "app/ui/panel/panel_context.h"
#include "app/ui/presets/preset_state.h"

namespace neph::ui {

/// Reads images that are there, has those made that are missing. Once per frame while they show.
void updateThumbnails(const PanelContext& context, PresetBrowser& presets);

/// Hands the images of the present cards to new ones of the same content, and drops the others.
void keepThumbnails(const Services& services, PresetBrowser& presets,
                    std::vector<PresetCard>& cards);

}  // namespace neph::ui
