// colour_editor.h: linear colours shown and chosen as the screen shows them.
#pragma once
#include <glm/glm.hpp>

namespace neph::ui {

/// A swatch as high as a line and as wide as ImGui's next item; a click opens a picker. `linear` is
/// linear RGB in [0, 1]. True when it changed.
bool colourEditor(const char* id, glm::vec3& linear);

/// The picker alone, for a popup.
bool colourPicker(glm::vec3& linear);

/// A filled rectangle of a linear colour, with a rim that shows on any ground.
void fillWithColour(glm::vec2 lower, glm::vec2 upper, const glm::vec3& linear);

}  // namespace neph::ui
