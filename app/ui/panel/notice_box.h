// notice_box.h: a box over the picture that never leaves its place.
#pragma once
#include "app/ui/panel/layout.h"

namespace neph::ui {

/// Which part of the picture a notice stands in.
enum class NoticeAt { top, middle, bottom };

/// Pair with endNotice(), whatever it returns. `picture` is the area of the image.
bool beginNotice(const Area& picture, const char* name, NoticeAt at);
void endNotice();

}  // namespace neph::ui
