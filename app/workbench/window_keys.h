// window_keys.h: keys of the window system and keys of chords.
#pragma once
#include "app/ui/widgets/chord.h"

namespace neph {

/// What a key of the window system stands for in chords; none where it stands for nothing.
ui::Key keyOf(int key, int scancode);

/// The window system's key; -1 where it has none of its own.
int codeOf(ui::Key key);

}  // namespace neph
