// notice_box.h: a box over the image that never leaves its place.
#pragma once
#include "app/ui/panel/layout.h"

namespace neph::ui {

/// Which part of the image a notice stands in.
enum class NoticeAt { top, middle };

/// How wide a notice may be.
float noticeWidth(const Area& image);

/// Pair with endNotice(), whatever it returns. `image` is the area of the image.
bool beginNotice(const Area& image, const char* name, NoticeAt at);
void endNotice();

}  // namespace neph::ui
