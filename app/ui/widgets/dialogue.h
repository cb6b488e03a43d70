// dialogue.h: dialogues that stay within the window, however large the text: they shrink to it, and
// scroll where that is not enough.
#pragma once
#include <glm/glm.hpp>

namespace neph::ui {

/// What the window has room for, pixels.
glm::vec2 dialogueRoom();

/// Width of a dialogue of so many letters, or what there is room for.
float dialogueWidth(float ems);

/// Width of an item of so many letters in a dialogue that is as wide as its contents, or what there
/// is room for beside `besideEms` letters of other items.
float itemWidth(float ems, float besideEms = 0.0f);

/// The next window stands in the middle, as wide as `widthPx` (0: as its contents) and no larger
/// than there is room for.
void nextDialogue(float widthPx = 0.0f);

/// What blocks the panels until it is answered; the popup of this name was opened. Pair with
/// ImGui::EndPopup() where it returns true.
bool beginModal(const char* title, float widthPx = 0.0f);

/// The next button with this label stands beside the last item, or below it where a window of
/// `widthPx` (0: as wide as there is room for) ends before that. `more` is what a kind of button
/// has around its label, pixels; none: what a plain one has.
void beside(const char* label, float widthPx = 0.0f, float more = 0.0f);

}  // namespace neph::ui
