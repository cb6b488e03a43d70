// notices.h: what is said over the image: loading, errors, empty states; and all messages as a
// list.
#pragma once
#include <cstdint>

#include "app/ui/data/session_files.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

/// Errors up to `dismissedSerial` were closed.
void drawNotices(const PanelContext& context, SessionDialogs& dialogs,
                 std::uint64_t& dismissedSerial);

/// `shown` becomes false when the list is closed.
void drawMessages(const PanelContext& context, bool& shown);

/// How to find what there is, for whoever opens the window for the first time.
void drawKeyHint(const PanelContext& context, std::uint64_t dismissedSerial, bool& shown);

}  // namespace neph::ui
