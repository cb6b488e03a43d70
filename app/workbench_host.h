// workbench_host.h: ImGui in a GLFW window: backends, fonts, keys and dropped files.
#pragma once
#include <deque>
#include <filesystem>
#include <vector>

#include "app/gl/context.h"
#include "app/ui/actions.h"
#include "app/ui/ui.h"

namespace neph {

/// Lives as long as the window; not copied, because the window's callbacks point to it.
class WorkbenchHost {
  public:
    explicit WorkbenchHost(gl::Window& window);
    ~WorkbenchHost();
    WorkbenchHost(const WorkbenchHost&) = delete;
    WorkbenchHost& operator=(const WorkbenchHost&) = delete;

    void beginFrame();
    /// Shows the frame: `picture`, a texture of `sizePx` or 0 for none, in its place below the
    /// panels.
    void endFrame(const ui::PixelBox& place, unsigned picture, glm::ivec2 sizePx);

    /// Chords pressed and files dropped since the last call.
    std::vector<ui::Chord> takeChords();
    std::vector<std::filesystem::path> takeDropped();

    /// Whether the window came to the fore since the last call.
    bool takeFocus();

    /// Waits for input, a wake-up or the time to pass; 0 only looks.
    void wait(double seconds);
    /// Ends a wait; from any thread.
    static void wake();

    /// Looks for input without taking it; true when a key, a button, the wheel or the window waits
    /// to be dealt with. Not between beginFrame and endFrame.
    bool inputWaits();

    /// Whether a mouse button is down.
    bool interacting() const;

    void close();
    void toggleFullScreen();

    void onKey(int key, int scancode, int mods);
    void onMouseButton(int button, bool down);
    void onOther() { inputSeen_ = true; }
    void onFocus();
    void onDrop(int count, const char** paths);

  private:
    struct Press {
        int button = 0;
        glm::vec2 at{0.0f};  ///< where it went down, then where it came up
        bool released = false;
        bool shown = false;  ///< ImGui has seen it go down
    };

    void holdTappedKeys();
    void replayPresses();

    gl::Window& window_;
    std::vector<ui::Chord> chords_;
    std::deque<Press> presses_;       // of mouse buttons, that ImGui has not seen through
    std::vector<int> tapped_, held_;  // keys pressed since the last frame, and those held for it
    std::vector<std::filesystem::path> dropped_;
    glm::ivec4 windowed_{0};  // x, y, width, height to go back to from full screen
    bool fullScreen_ = false;
    bool focused_ = false;
    bool inputSeen_ = false;  ///< since the last wait
};

}  // namespace neph
