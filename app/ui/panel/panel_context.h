// panel_context.h: what every panel is given: the session it edits, the settings, what the window
// does for it and what it may ask for.
//
// A panel gets this and the state of its own room, and knows no other panel. What it wishes of
// others it leaves in `Requests`, or it asks for one of the program's actions by its id.
#pragma once
#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "app/ui/panel/layout.h"
#include "app/ui/panel/services.h"
#include "core/session/session.h"
#include "core/session/settings.h"

namespace neph::ui {

/// Wishes: of the window, which carries them out after the frame, and of other panels, which the
/// shell carries out before the next panel is drawn.
struct Requests {
    bool quit = false;
    bool toggleFullScreen = false;
    bool reloadShaders = false;
    bool redraw = false;                ///< the image, though nothing has changed
    std::optional<std::string> memory;  ///< a setting to use and to remember
    bool restyle = false;               ///< theme or scale are others: before the next frame
    std::optional<std::string> preset;  ///< file of one to load; of the presets' room
};

/// Seconds between looks at what goes on in the background.
inline constexpr double kLookS = 0.2;

/// When the next frame is due. Cleared before each, and set by what is drawn in it.
struct NextFrame {
    bool animates = false;  ///< something moves by itself
    /// Seconds after which panels are to be drawn again, though nothing moves.
    double againS = std::numeric_limits<double>::infinity();
    void again(double seconds) { againS = std::min(againS, seconds); }
};

/// An action as a button shows it.
struct ActionFace {
    std::string tooltip;  ///< label, help and chord
    bool enabled = false;
    bool on = false;  ///< of a switch
};

/// The program's actions, by id: "camera.fit".
struct ActionLookup {
    std::function<ActionFace(std::string_view id)> face;
    std::function<void(std::string_view id)> run;  ///< where it is enabled
};

struct PanelContext {
    Session* const& active;  ///< of the slot that panels edit; another one after a restore
    Settings& settings;      ///< remembered when they change
    const Services& services;
    Requests& requests;
    NextFrame& next;
    const Columns& columns;
    ActionLookup actions;

    Session& session() const { return *active; }
    Layout layout() const { return layoutOf(session(), settings, columns); }
};

}  // namespace neph::ui
