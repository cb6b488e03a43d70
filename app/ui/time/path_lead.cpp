// path_lead.cpp: when the path has the camera, and when its own comes back.
#include "app/ui/time/path_lead.h"

#include <utility>

namespace neph::ui {

void leadAlongPath(Session& session, Playback& playback) {
    Document& document = session.document;
    std::optional<LedCamera>& led = playback.led;
    const VolumeSummary* shown = session.shown();
    const bool leads = led.has_value();
    keepOwnCamera(session, playback);
    const bool taken = leads && !led;  // by the user
    if (taken || shown == nullptr || document.path.keys.empty()) return;
    playback.alongPath = true;
    if (!led) led = LedCamera{document.camera, document.camera, shown->grid.movedM};
    document.camera = led->now = poseAt(document.path, shown->grid, playback.atS);
    const int count =
        session.info() == nullptr ? 0 : static_cast<int>(session.info()->times.size());
    if (const auto time = timeAt(document.path, playback.atS, count)) document.time = *time;
}

void keepOwnCamera(Session& session, Playback& playback) {
    CameraPose& camera = session.document.camera;
    std::optional<LedCamera>& led = playback.led;
    if (!led) return;
    if (const VolumeSummary* shown = session.shown()) {  // as the session has moved its own
        const glm::dvec2 movedM =
            shown->grid.movedM - std::exchange(led->movedM, shown->grid.movedM);
        keepOnGround(led->before, shown->grid, movedM);
        keepOnGround(led->now, shown->grid, movedM);
    }
    if (camera != led->now) {
        playback.alongPath = playback.playing = false;
    } else if (!playback.alongPath) {
        camera = led->before;
    } else {
        return;
    }
    led.reset();
}

}  // namespace neph::ui
