// preset_placeholder.h: what a preset's card shows until its thumbnail is there: sky and ground as
// they are behind the storm of the thumbnail.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "core/preset/preset.h"

namespace neph::ui {

/// Colours at the corners of a mesh, rows from the top; encoded sRGB, 0 to 1.
struct PresetPlaceholder {
    static constexpr int kColumns = 4, kSkyRows = 6, kGroundRows = 4;
    template <int kRows>
    using Mesh = std::array<glm::vec3, (kColumns + 1) * (kRows + 1)>;

    float horizon = 1.0f;  ///< of the height from the top: where the ground begins
    Mesh<kSkyRows> sky{};
    Mesh<kGroundRows> ground{};
};

/// Takes a millisecond, and a tenth of a second where no look in use has its air.
PresetPlaceholder placeholderOf(const Preset& preset);

/// Into the current window.
void drawPlaceholder(const PresetPlaceholder& placeholder, glm::vec2 lower, glm::vec2 upper);

}  // namespace neph::ui
