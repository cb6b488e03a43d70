// notice_box.h: a box over the picture that never leaves its place.
#pragma once
#include <cstddef>
#include <string>

#include "app/ui/shell/ui.h"

namespace neph::ui {

/// Which part of the picture a notice stands in.
enum class NoticeAt { top, middle, bottom };

/// Pair with endNotice(), whatever it returns.
bool beginNotice(const Ui& ui, const char* name, NoticeAt at);
void endNotice();

/// Offers to restore what a crash left, where there is anything.
void drawCrashNotice(Ui& ui);

/// Buttons for what was opened lately, `count` at most; returns the entry chosen, or nothing.
std::string drawRecentList(Ui& ui, std::size_t count);

}  // namespace neph::ui
