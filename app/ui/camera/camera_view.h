// camera_view.h: the camera of the slot that panels edit, in the world that it shows.
#pragma once
#include "app/ui/shell/ui.h"
#include "core/camera/camera_moves.h"

namespace neph::ui {

/// What poses are shares of: the grid that is shown, or a cube until data are there.
RegularGrid gridOf(const Session& session);

/// Width / height of the picture.
double aspectOf(const Ui& ui);

/// What views frame: the clouds that are seen, or the whole of what is shown where there are none.
Region framedBox(const Session& session);

/// Turns the camera to a side, with all that is framed in the picture.
void look(Ui& ui, View view);

/// From the ground, in the eye's direction from the target, to the target.
void lookFromGround(Ui& ui);

/// Adds the camera to the bookmarks, or to the end of the path.
void addBookmark(Ui& ui);
void addPathKey(Ui& ui);

/// Camera and time as they are where the path is now. The document's own camera comes back when
/// the path is left, but where a hand has moved it.
void leadAlongPath(Ui& ui);
/// Notices that the path was left. Once a frame.
void keepOwnCamera(Ui& ui);

/// "12.3 km", "850 m", "2 m": at most three digits that say something.
std::string lengthText(double lengthM);

}  // namespace neph::ui
