// time_bar.h: playing through the times of the data, or along the camera path.
#pragma once
#include "app/ui/panel/panel_context.h"
#include "app/ui/time/playback.h"

namespace neph::ui {

/// Index of the last time of the data, 0 before any.
int lastTime(const Session& session);

/// Goes `steps` members on, past those that lack the time that is shown, which is said; from the
/// mean to the first or the last.
void stepMember(Session& session, int steps);

/// Moves on where something is played. `imageTime`: of the data in the image that is shown; -1
/// where that is not known.
void playOn(const PanelContext& context, Playback& playback, int imageTime);

void drawTimeBar(const PanelContext& context, Playback& playback);

}  // namespace neph::ui
