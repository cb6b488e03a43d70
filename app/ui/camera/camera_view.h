// camera_view.h: the camera of the slot that panels edit, in the world that it shows.
#pragma once
#include "app/ui/camera/camera_tools.h"
#include "app/ui/panel/layout.h"
#include "app/ui/time/playback.h"
#include "core/camera/camera_moves.h"
#include "core/grid/boxes.h"
#include "core/session/session.h"

namespace neph::ui {

/// What poses are shares of: the grid that is shown, or a cube until data are there.
RegularGrid gridOf(const Session& session);

/// Width / height of the image.
double aspectOf(const Layout& layout);

/// Turns the camera to a side, with all that is seen in an image of `aspect`; nothing before data
/// are there.
void look(Session& session, View view, double aspect);

/// Data that were opened are shown whole in an image of `aspect`, from the side that they would be
/// seen from; that view is home, and no step of the history.
void frameOpened(Session& session, double aspect);

/// From the ground, in the eye's direction from the target, to the target.
void lookFromGround(Session& session, CameraTools& tools);

/// Adds the camera to the bookmarks, or to the path: where it stands while it leads, else at its
/// end.
void addBookmark(Session& session);
void addPathKey(Session& session, const Playback& playback);

/// "12.3 km", "850 m", "2 m": at most three digits that say something.
std::string lengthText(double lengthM);

}  // namespace neph::ui
