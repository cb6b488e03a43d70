// colours.h: the colours that tell fields apart, and linear light as the screen spells it.
//
// Linear RGB in [0, 1] with the primaries of sRGB, as everywhere in core.
#pragma once
#include <glm/glm.hpp>

#include "core/look/look.h"

namespace neph {

/// Per channel, IEC 61966-2-1.
glm::vec3 srgbFromLinear(const glm::vec3& linear);
glm::vec3 linearFromSrgb(const glm::vec3& srgb);

/// Field colours of a look: those of [Riley03] table 2, or accessible ones, which people with any
/// common colour blindness can tell apart.
enum class FieldColours : int { table2, accessible };

glm::vec3 fieldColour(FieldColours colours, Species species);
bool hasFieldColours(const Look& look, FieldColours colours);
void setFieldColours(Look& look, FieldColours colours);

}  // namespace neph
