// preset_card.h: one preset in the grid: its image, its name and what can be done with it.
#pragma once
#include <glm/glm.hpp>
#include <string>

#include "app/ui/presets/preset_state.h"
#include "core/session/session.h"

namespace neph::ui {

/// Width over height of the images.
inline constexpr float kThumbnailAspect = 16.0f / 9.0f;

/// Height of a card of this width.
float presetCardHeight(float width);

/// At the cursor. A click loads the preset, a right click opens a menu, "..." the details.
void drawPresetCard(Session& session, PresetBrowser& presets, const PresetCard& card, float width);

/// The image, or the preset's sky and ground where there is none yet.
void drawPresetImage(const PresetCard& card, glm::vec2 lower, glm::vec2 upper);

/// Title, description, and what the preset would change; at most `most` lines of that.
std::string describePresetCard(const Session& session, const PresetCard& card, std::size_t most);

}  // namespace neph::ui
