// input.h: what panels ask of ImGui's last item, of text and of the keyboard.
#pragma once
#include <imgui.h>

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "app/ui/widgets/area.h"

namespace neph::ui {

/// Whether the last item, disabled or not, should explain itself: the mouse is on it, and has moved
/// since it last clicked anything.
bool wantsTooltip();

/// A tooltip for the last item where it wants one, in lines that are easy to read.
void tooltip(const std::string& text);

/// The same with any contents: `endTooltip` belongs to each that returns true.
bool beginTooltip();
void endTooltip();

/// The next tooltip, `size` pixels large or as large as the last one, stands beside `item`.
void nextTooltipBeside(const Area& item, std::optional<glm::vec2> size = {});

/// Where a tooltip covers no part of an item and is within the window: below the item, above it, or
/// at its side, which comes first where `sideways`. None where there is no such place.
std::optional<glm::vec2> besideItem(const Area& item, glm::vec2 size, glm::vec2 window,
                                    glm::vec2 mouse, bool sideways);

/// ImGui's last item.
Area lastItem();

/// `text`, or as much of it as goes into `width` pixels with two dots behind it.
std::string shortened(const std::string& text, float width);

/// Turns a comma that is typed into one of ImGui's own fields for numbers to a point; ImGui would
/// drop it, and make 5 of "0,5". Once per frame, before what is drawn.
void takeDecimalCommas();
/// Says that the last item is such a field; sliders and drags are known.
void noteNumberField();

/// Whether ImGui needs another frame before it takes keys as what is on the screen suggests: a line
/// that is about to have the keyboard, or has just given it up.
bool inputUnsettled();

/// Whether a key went down in this frame, or repeats.
inline bool pressed(ImGuiKey key) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

}  // namespace neph::ui
