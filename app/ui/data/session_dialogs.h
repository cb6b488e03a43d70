// session_dialogs.h: data that have moved, what was opened recently, and what a crash left.
#pragma once
#include <cstddef>
#include <string>

#include "app/ui/data/session_files.h"

namespace neph::ui {

void drawSessionDialogs(const PanelContext& context, SessionDialogs& dialogs);

/// Offers to restore what a crash left, where there is anything.
void drawCrashNotice(const PanelContext& context, SessionDialogs& dialogs);

/// Buttons for what was opened recently, `count` at most; returns the entry chosen, or nothing.
std::string drawRecentList(const PanelContext& context, SessionDialogs& dialogs, std::size_t count);

}  // namespace neph::ui
