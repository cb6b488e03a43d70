// ui.h: what the panels share: the session they edit, what the last frame was, and what they ask of
// the window.
//
// Panels see core and ImGui, and leave room for the picture, which the window draws itself.
// Requests are plain flags that the workbench carries out after the frame.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/camera/camera_tools.h"
#include "app/ui/compare/compare.h"
#include "app/ui/compare/compare_errors.h"
#include "app/ui/data/session_dialogs.h"
#include "app/ui/fields/fields_state.h"
#include "app/ui/output/output_state.h"
#include "app/ui/presets/preset_browser.h"
#include "app/ui/shell/palette.h"
#include "app/ui/time/playback.h"
#include "app/ui/widgets/layout.h"
#include "app/ui/widgets/profile.h"
#include "app/ui/widgets/reference_report.h"
#include "core/image/image.h"
#include "core/session/session.h"
#include "core/session/session_state.h"
#include "core/session/settings.h"

namespace neph::ui {

/// The picture on screen, for the status line.
struct FrameReport {
    double milliseconds = 0.0;
    Engine engine{};
    int planes = 0;   ///< slices, or steps of the march along the diagonal
    int samples = 0;  ///< pictures that were averaged
    glm::ivec2 sizePx{0};
    bool full = false;  ///< at the resolution of the window and with all planes or steps
    std::string device;
    std::size_t gpuBytes = 0;     ///< held for this slot's pictures
    int time = -1;                ///< of the data in it; -1: not told
    ReferenceReport reference{};  ///< of that engine alone
};

struct Requests {
    bool quit = false;
    bool toggleFullScreen = false;
    bool reloadShaders = false;
    bool redraw = false;                ///< the picture, though nothing has changed
    std::optional<std::string> memory;  ///< a setting to use and to remember
    bool restyle = false;               ///< theme or scale are others: before the next frame
};

/// A picture as a texture.
struct LoadedPicture {
    unsigned texture = 0;  ///< for ImGui; 0 where the file could not be read
    glm::ivec2 sizePx{0};
};

/// What the window does for panels, which know neither GL nor picture files. Empty in tests.
struct Services {
    std::function<LoadedPicture(const std::filesystem::path& png)> loadPicture;
    std::function<LoadedPicture(const Image8& picture)> showPicture;
    std::function<void(unsigned texture)> dropPicture;
    /// What a session file would hold now; panels hand it to what runs beside the program.
    std::function<SessionState()> state;
    /// Takes over a session file's state.
    std::function<void(const SessionState&)> restore;
};

/// Seconds between looks at what goes on beside the window.
inline constexpr double kLookS = 0.2;

struct Ui {
    Ui() = default;
    explicit Ui(Session& edited) : active(&edited) {}

    Session* active = nullptr;  ///< of the slot that panels edit; set before the first frame
    Session& session() const { return *active; }

    Settings settings;  ///< remembered when they change
    Services services;
    FrameReport report;
    Profile profile;  ///< kept up to date while it is shown
    Requests requests;
    Columns columns;
    bool showPanels = true;
    bool showHelp = false;
    bool showMessages = false;
    bool showProfile = false;
    bool askForPath = false;            ///< opens the popup in the next frame
    std::uint64_t dismissedSerial = 0;  ///< errors up to here were closed
    /// Something moves by itself: set anew in every frame in which it does.
    bool animates = false;
    /// Seconds after which panels are to be drawn again, though nothing moves; set anew likewise.
    double againS = std::numeric_limits<double>::infinity();
    void again(double seconds) { againS = std::min(againS, seconds); }
    PresetBrowser presets;
    CameraTools cameraTools;
    CompareState compare;
    CompareErrors errors;
    FieldsState fields;
    OutputState output;
    Palette palette;
    Playback playback;
    SessionDialogs sessionDialogs;
    std::string path;                     ///< as typed
    std::string memory;                   ///< as typed
    std::array<glm::vec3, 2> regionKm{};  ///< lower and upper corner, as dragged
    bool editsRegion = false;             ///< the hand is on a slider
};

/// Camera under the mouse, menus, columns, time bar, status line, popups. Call between NewFrame and
/// Render.
void draw(Ui& ui);

/// A part of the window, pixels of its framebuffer, row 0 at the bottom.
struct PixelBox {
    glm::ivec2 lower{0}, upper{1};  ///< corners; `upper` is outside
    glm::ivec2 size() const { return upper - lower; }
};
/// Where the picture is: all that the panels leave. At least a pixel.
PixelBox pictureBox(const Ui& ui);

}  // namespace neph::ui
