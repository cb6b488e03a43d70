// profile_overlay.h: what the image cost, in the corner of it.
#pragma once
#include "app/ui/panel/layout.h"
#include "app/ui/widgets/profile.h"

namespace neph::ui {

/// `image` is the area of the image.
void drawProfile(const Area& image, const Profile& profile);

}  // namespace neph::ui
