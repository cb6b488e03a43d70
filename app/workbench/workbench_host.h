// workbench_host.h: ImGui in a GLFW window: backends, fonts, keys and dropped files.
#pragma once
#include <deque>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "app/gl/context.h"
#include "app/ui/panel/layout.h"
#include "app/ui/widgets/chord.h"
#include "app/workbench/key_queue.h"
#include "app/workbench/script_player.h"
#include "app/workbench/window_fit.h"
#include "core/grid/boxes.h"
#include "core/image/image.h"
#include "core/session/settings.h"

namespace neph {

/// An image on the screen, or the part of it between two shares of its width.
struct HostImage {
    PixelBox place;
    unsigned texture = 0;  ///< 0: none yet
    glm::ivec2 sizePx{1};
    glm::vec2 widthShare{0.0f, 1.0f};
};

/// Lives as long as the window; not copied, because the window's callbacks point to it.
class WorkbenchHost {
  public:
    /// Shows the window, where it was left if that is told, and all of it on the screen.
    WorkbenchHost(gl::Window& window, const std::optional<WindowPlace>& left);
    ~WorkbenchHost();
    WorkbenchHost(const WorkbenchHost&) = delete;
    WorkbenchHost& operator=(const WorkbenchHost&) = delete;

    /// Theme, spacing and font, again.
    void restyle(const Settings& settings);

    void beginFrame();
    /// Shows the frame: images in their places below the panels. `shot`, if any, gets what is
    /// shown.
    void endFrame(std::span<const HostImage> images, Image8* shot = nullptr);

    /// Of the window, in the units of the mouse.
    glm::vec2 sizePx() const;
    void resize(glm::ivec2 size);
    /// Of the window on the screen; of a full screen where it was before.
    WindowPlace place() const;

    /// Chords pressed and files dropped since the last call.
    std::vector<ui::Chord> takeChords();
    std::vector<std::filesystem::path> takeDropped();

    /// Whether the window came to the fore since the last call.
    bool takeFocus();

    /// Waits for input, a wake-up or the time to pass; 0 only looks. False when nothing happened.
    bool wait(double seconds);
    /// Ends a wait; from any thread.
    static void wake();

    /// Looks for input without taking it; true when there is any that panels have not seen. Not
    /// between beginFrame and endFrame.
    bool inputWaits();
    /// Whether chords or dropped files wait to be taken, or the window is to be closed.
    bool commandsWait() const;

    /// Mouse and keys of the next frame; those of the window are not heeded from then on.
    void play(const PlayedInput& input);

    /// Whether a mouse button is down.
    bool interacting() const;

    void close();
    /// Whether the window was to be closed since the last call.
    bool takeClose();
    void toggleFullScreen();

    void onKey(int key, int scancode, int action, int mods);
    void onLetter(unsigned letter);
    void onMouseButton(int button, bool down);
    void fitToScreen(bool moves);
    void onOther() { unseen_ = true; }
    void onFocus();
    void onDrop(int count, const char** paths);

  private:
    struct Press {
        int button = 0;
        glm::vec2 at{0.0f};  ///< where it went down, then where it came up
        bool released = false;
        bool shown = false;       ///< ImGui has seen it go down
        std::uint64_t order = 0;  ///< among all input
    };

    void replayKeys();
    bool keysWait() const;
    void applyPlayed();
    void takeChord(ui::Chord chord);
    void replayPresses();

    gl::Window& window_;
    std::vector<ui::Chord> chords_;
    std::deque<Press> presses_;  // of mouse buttons, that ImGui has not seen through
    KeyQueue keys_;              // that ImGui has not seen
    std::uint64_t order_ = 0;    // of the newest input
    int settling_ = 0;           // frames that keys wait for after a command
    std::vector<std::filesystem::path> dropped_;
    ScreenBox windowed_;  // to go back to from full screen
    WindowFrame frame_;   // of it
    bool fullScreen_ = false;
    bool focused_ = false;
    std::optional<PlayedInput> played_;
    bool unseen_ = true;  ///< something has happened since the last beginFrame
};

}  // namespace neph
