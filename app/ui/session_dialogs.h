// session_dialogs.h: what the dialogues of session files keep between frames.
#pragma once

namespace neph::ui {

struct SessionDialogs {};

}  // namespace neph::ui
