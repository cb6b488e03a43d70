// data_panel.h: what is open, which part of it is shown, and the memory that it takes.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string>

#include "app/ui/panel/panel_context.h"

namespace neph::ui {

/// What is being edited.
struct DataEdits {
    std::string memory;                   ///< as typed
    std::array<glm::vec3, 2> regionKm{};  ///< lower and upper corner, as dragged
    bool holdsRegion = false;             ///< the mouse is on a slider
};

void drawData(const PanelContext& context, DataEdits& edits);

/// Shows the part of the domain that holds the clouds that are seen, with a margin.
void showAroundClouds(Session& session);

}  // namespace neph::ui
