// fields_icons.h: the signs of a field's row, drawn, because no font has them all.
#pragma once
#include <glm/glm.hpp>

namespace neph::ui {

/// An eye, open or struck through. All are as high as a line; true when clicked.
bool eyeButton(const char* id, bool open, float width);
/// A letter that is lit while it is on.
bool letterButton(const char* letter, bool lit, float width);
/// Two links of a chain, closed or apart.
bool chainButton(const char* id, bool closed, float width);
/// A swatch of linear `colour`, with a rim of `rim`.
bool swatchButton(const char* id, const glm::vec3& colour, const glm::vec3& rim, float width);

}  // namespace neph::ui
