// path_lead.h: the document's camera while the camera path leads it.
#pragma once
#include "app/ui/time/playback.h"
#include "core/session/session.h"

namespace neph::ui {

/// Camera and time as they are where the path is now. The document's own camera comes back when
/// the path is left, but where the user has moved it.
void leadAlongPath(Session& session, Playback& playback);
/// Notices that the path was left. Once per frame.
void keepOwnCamera(Session& session, Playback& playback);

}  // namespace neph::ui
