// pointing.h: what the mouse over the image points at.
#pragma once
#include <optional>

#include "app/ui/ask/ask_state.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

/// What is shown of the session now, of an ensemble the member's run; nothing before data are
/// there, and of a mean, which no model has computed.
std::optional<AskedTime> askedTimeOf(const Session& session);

/// Along the ray under the mouse; nothing where the mouse is not over the image alone.
std::optional<PointedAt> pointedAt(const PanelContext& context);

/// Where it is on the screen; nothing where it is not in the image.
std::optional<glm::vec2> onScreen(const PanelContext& context, const glm::dvec3& positionM);

/// Takes clicks and drags over the image for the tools that are on, and draws what they show.
void drawPointing(const PanelContext& context, AskState& ask);

}  // namespace neph::ui
