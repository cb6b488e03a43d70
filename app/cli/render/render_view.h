// render_view.h: a place or a side to look from, in place of the preset's camera.
#pragma once
#include <optional>
#include <string>

#include "app/cli/common/scene.h"
#include "core/camera/camera_moves.h"
#include "core/volume/held_volume.h"

namespace neph {

/// At most one of the two.
struct RenderView {
    std::optional<Observer> observer;
    std::optional<View> view;
    bool given() const { return observer || view; }
};

/// From "east,north,height,azimuth,elevation[,fov]" in km, km, m and degrees. Throws UsageError.
Observer parseObserver(const std::string& text);

/// By its name. Throws UsageError.
View parseView(const std::string& name);

/// What was asked for; where no camera was, all of the cloud, as the window shows it at first.
RenderView firstView(const RenderView& asked, const Scene& scene);

/// The camera to look at `shown` with, in an image of this aspect; `pose` has what is not told.
/// Throws UsageError where an observer is too far away.
CameraPose poseOf(const RenderView& from, const CameraPose& pose, const VolumeSummary& shown,
                  const Look& look, double aspect);

}  // namespace neph
