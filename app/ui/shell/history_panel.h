// history_panel.h: the list of steps, to go back to.
#pragma once
#include <cstddef>

#include "core/session/session.h"

namespace neph::ui {

/// `shown` becomes false when the list is closed; `seen` is the position it was last scrolled to.
void drawHistory(Session& session, bool& shown, std::size_t& seen);

}  // namespace neph::ui
