// ui.h: what the panels share: the session they edit, what the last frame was, and what they ask of
// the window.
//
// Panels see core and ImGui, and leave room for the picture, which the window draws itself.
// Requests are plain flags that the workbench carries out after the frame.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/profile.h"
#include "core/preset.h"
#include "core/session.h"

namespace neph::ui {

/// The picture on screen, for the status line.
struct FrameReport {
    double milliseconds = 0.0;
    Engine engine = Engine::march;
    int planes = 0;   ///< slices, or steps of the march along the diagonal
    int samples = 0;  ///< pictures that were averaged
    glm::ivec2 sizePx{0};
    bool full = false;  ///< at the resolution of the window and with all planes or steps
    std::string device;
};

struct Requests {
    bool quit = false;
    bool toggleFullScreen = false;
    bool reloadShaders = false;
    bool redraw = false;                ///< the picture, though nothing has changed
    std::optional<std::string> memory;  ///< a setting to use and to remember
};

struct Ui {
    explicit Ui(Session& edited) : session(edited) {}

    Session& session;
    FrameReport report;
    Profile profile;  ///< kept up to date while it is shown
    Requests requests;
    bool showPanels = true;
    bool showHelp = false;
    bool showMessages = false;
    bool showProfile = false;
    bool askForPath = false;            ///< opens the popup in the next frame
    bool askForPresetName = false;      ///< moves the keyboard to the preset's name
    std::uint64_t dismissedSerial = 0;  ///< errors up to here were closed
    std::vector<PresetEntry> presets;   ///< as last listed
    std::vector<std::string> titles;    ///< of `presets`
    bool presetsListed = false;
    std::string presetName;               ///< as typed
    std::string path;                     ///< as typed
    std::string memory;                   ///< as typed
    std::array<glm::vec3, 2> regionKm{};  ///< lower and upper corner, as dragged
    bool editsRegion = false;             ///< the hand is on a slider
};

/// Camera under the mouse, columns, time bar, status line, popups. Call between NewFrame and
/// Render.
void draw(Ui& ui);

/// A part of the window, pixels of its framebuffer, row 0 at the bottom.
struct PixelBox {
    glm::ivec2 lower{0}, upper{1};  ///< corners; `upper` is outside
    glm::ivec2 size() const { return upper - lower; }
};
/// Where the picture is: all that the panels leave. At least a pixel.
PixelBox pictureBox(const Ui& ui);

/// Width of a side column, heights of the status line and of the time bar, 0 where there is but one
/// time; pixels.
float columnWidth();
float statusHeight();
float timeBarHeight(const Session& session);

}  // namespace neph::ui
