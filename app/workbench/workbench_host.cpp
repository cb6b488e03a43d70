// workbench_host.cpp: the only file that knows both ImGui's backends and GLFW.
#include "app/workbench/workbench_host.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <utility>

#include "app/ui/widgets/input.h"
#include "app/ui/widgets/theme.h"
#include "app/workbench/window_keys.h"

namespace neph {
namespace {

std::atomic<bool> woken = false;  // since the last wait

constexpr int kSettlingFrames = 3;        // in which a line of text that opens takes the keyboard
constexpr glm::ivec2 kLeastPx{960, 600};  // both columns and an image between them

/// The part of a screen that windows may take; the whole screen where the window system says
/// nothing of panels.
ScreenBox workAreaOf(GLFWmonitor* monitor) {
    ScreenBox area;
    glfwGetMonitorWorkarea(monitor, &area.at.x, &area.at.y, &area.size.x, &area.size.y);
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    if (area.size.x > 0 || mode == nullptr) return area;
    glfwGetMonitorPos(monitor, &area.at.x, &area.at.y);
    area.size = {mode->width, mode->height};
    return area;
}

ScreenBox placeOf(GLFWwindow* window) {
    ScreenBox place;
    glfwGetWindowPos(window, &place.at.x, &place.at.y);
    glfwGetWindowSize(window, &place.size.x, &place.size.y);
    return place;
}

WindowFrame frameOf(GLFWwindow* window) {
    WindowFrame frame;
    glfwGetWindowFrameSize(window, &frame.before.x, &frame.before.y, &frame.after.x,
                           &frame.after.y);
    return frame;
}

/// The monitor that shows most of a window, else the first; nullptr without any.
GLFWmonitor* monitorOf(const ScreenBox& window) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    if (monitors == nullptr || count == 0) return nullptr;
    return *std::max_element(monitors, monitors + count, [&](GLFWmonitor* a, GLFWmonitor* b) {
        return sharedArea(window, workAreaOf(a)) < sharedArea(window, workAreaOf(b));
    });
}

WorkbenchHost& hostOf(GLFWwindow* window) {
    return *static_cast<WorkbenchHost*>(glfwGetWindowUserPointer(window));
}

}  // namespace

WorkbenchHost::WorkbenchHost(gl::Window& window, const std::optional<WindowPlace>& left)
    : window_(window) {
    GLFWwindow* handle = window.handle();
    glfwSetWindowUserPointer(handle, this);
    glfwSetMouseButtonCallback(handle, [](GLFWwindow* w, int button, int action, int) {
        hostOf(w).onMouseButton(button, action == GLFW_PRESS);
    });
    glfwSetCursorPosCallback(handle, [](GLFWwindow* w, double, double) { hostOf(w).onOther(); });
    glfwSetScrollCallback(handle, [](GLFWwindow* w, double, double) { hostOf(w).onOther(); });
    glfwSetWindowCloseCallback(handle, [](GLFWwindow* w) { hostOf(w).onOther(); });
    glfwSetFramebufferSizeCallback(handle, [](GLFWwindow* w, int, int) { hostOf(w).onOther(); });
    glfwSetWindowFocusCallback(handle, [](GLFWwindow* w, int focused) {
        if (focused != 0) hostOf(w).onFocus();
    });
    glfwSetDropCallback(handle, [](GLFWwindow* w, int count, const char** paths) {
        hostOf(w).onDrop(count, paths);
    });
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // panels stand where they stand
    ui::restyle(window.contentScale(), {});
    ImGui_ImplGlfw_InitForOpenGL(handle, true);  // chains the callbacks set above
    // Keys reach ImGui by way of the queue.
    glfwSetKeyCallback(handle, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        hostOf(w).onKey(key, scancode, action, mods);
    });
    glfwSetCharCallback(handle, [](GLFWwindow* w, unsigned letter) { hostOf(w).onLetter(letter); });
    ImGui_ImplOpenGL3_Init("#version 450");
    if (left) {
        glfwSetWindowSize(handle, left->width, left->height);
        glfwSetWindowPos(handle, left->x, left->y);
    }
    // The window system finds a place for a new window, if it is not too large.
    fitToScreen(left.has_value());
    glfwShowWindow(handle);
    glfwPollEvents();
    fitToScreen(true);
}

/// A window on a screen that is smaller, or gone, is cut, and moved where asked for, so that all of
/// it is seen.
void WorkbenchHost::fitToScreen(bool moves) {
    GLFWwindow* handle = window_.handle();
    const ScreenBox wanted = placeOf(handle);
    ScreenBox place = wanted;
    glm::ivec2 least = kLeastPx;
    if (GLFWmonitor* monitor = monitorOf(wanted)) {
        const ScreenBox area = workAreaOf(monitor);
        const WindowFrame frame = frameOf(handle);
        place = fitOn(area, wanted, frame);
        least = leastOn(area, kLeastPx, frame);
    }
    glfwSetWindowSizeLimits(handle, least.x, least.y, GLFW_DONT_CARE, GLFW_DONT_CARE);
    if (place.size != wanted.size) glfwSetWindowSize(handle, place.size.x, place.size.y);
    if (moves && place.at != wanted.at) glfwSetWindowPos(handle, place.at.x, place.at.y);
}

WorkbenchHost::~WorkbenchHost() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void WorkbenchHost::beginFrame() {
    unseen_ = false;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    if (played_) {
        applyPlayed();
    } else {
        replayKeys();
        replayPresses();
    }
    ImGui::NewFrame();
}

/// Keys wait for clicks that came before them, and after a command until what it opened takes them.
bool WorkbenchHost::keysWait() const {
    return settling_ > 0 || !chords_.empty() || ui::inputUnsettled();
}

/// Gives ImGui what it can tell apart in one frame. Which keys are commands is decided now, since
/// keys before them may have opened a line of text.
void WorkbenchHost::replayKeys() {
    if (settling_ > 0 && chords_.empty()) --settling_;
    if (keysWait()) return;
    const std::uint64_t until =
        presses_.empty() ? std::numeric_limits<std::uint64_t>::max() : presses_.front().order;
    for (const KeyEvent& event : keys_.take(until)) {
        if (event.kind == KeyEvent::Kind::letter) {
            ImGui_ImplGlfw_CharCallback(window_.handle(), event.letter);
            continue;
        }
        const bool down = event.kind == KeyEvent::Kind::down;
        ImGui_ImplGlfw_KeyCallback(window_.handle(), event.key, event.scancode,
                                   down ? GLFW_PRESS : GLFW_RELEASE, event.mods);
        if (!down) continue;
        const ui::Key named = keyOf(event.key, event.scancode);
        // Shift belongs to a sign: '?' is above '/', and '+' above '=' on many keyboards.
        const bool sign = named >= ui::Key::question && named <= ui::Key::minus;
        takeChord({named, (event.mods & GLFW_MOD_CONTROL) != 0,
                   !sign && (event.mods & GLFW_MOD_SHIFT) != 0});
        if (!chords_.empty()) settling_ = kSettlingFrames;
        // A line of text that this closes holds the keyboard until the frame after the next.
        const bool closes = event.key == GLFW_KEY_ENTER || event.key == GLFW_KEY_KP_ENTER ||
                            event.key == GLFW_KEY_ESCAPE;
        if (closes && ImGui::GetIO().WantTextInput) settling_ = kSettlingFrames;
    }
}

void WorkbenchHost::restyle(const Settings& settings) {
    ui::restyle(window_.contentScale(), settings);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

/// Panels have the window's own colour: to blend them over an image that they hide took a CPU that
/// stands in for a GPU longer than all that is on them.
void WorkbenchHost::endFrame(std::span<const HostImage> images, Image8* shot) {
    ImGui::Render();
    const ImVec4& colour = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
    window_.clear({colour.x, colour.y, colour.z});
    for (const HostImage& image : images) {
        if (image.texture == 0 || image.place.size().x < 1) continue;
        window_.fill(image.place, image.texture, image.sizePx, image.widthShare);
    }
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (shot != nullptr) {
        *shot = {{window_.framebufferWidth(), window_.framebufferHeight()}, window_.readRgba()};
    }
    window_.swap();
}

glm::vec2 WorkbenchHost::sizePx() const {
    int width = 1, height = 1;
    glfwGetWindowSize(window_.handle(), &width, &height);
    return {width, height};
}

void WorkbenchHost::resize(glm::ivec2 size) {
    glfwSetWindowSize(window_.handle(), size.x, size.y);
}

WindowPlace WorkbenchHost::place() const {
    const ScreenBox at = fullScreen_ ? windowed_ : placeOf(window_.handle());
    return {at.at.x, at.at.y, at.size.x, at.size.y};
}

/// ImGui looks at the mouse once per frame, too. After a slow frame it is shown where a button went
/// down, and in the next frame where it came up, so that no click goes astray.
void WorkbenchHost::replayPresses() {
    if (presses_.empty() || (!keys_.empty() && keys_.firstOrder() < presses_.front().order)) {
        return;
    }
    ImGuiIO& io = ImGui::GetIO();
    Press& press = presses_.front();
    if (!press.shown) {
        press.shown = true;
        io.MouseDown[press.button] = true;
        io.MousePos = {press.at.x, press.at.y};
    } else {
        if (press.released) {
            io.MouseDown[press.button] = false;
            io.MousePos = {press.at.x, press.at.y};
        }
        presses_.pop_front();
    }
}

std::vector<ui::Chord> WorkbenchHost::takeChords() {
    return std::exchange(chords_, {});
}

std::vector<std::filesystem::path> WorkbenchHost::takeDropped() {
    return std::exchange(dropped_, {});
}

bool WorkbenchHost::takeFocus() {
    return std::exchange(focused_, false);
}

bool WorkbenchHost::wait(double seconds) {
    const auto waiting = [this] { return unseen_ || !presses_.empty() || !keys_.empty(); };
    if (waiting()) seconds = 0.0;
    if (seconds > 0.0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
    return woken.exchange(false) || waiting();
}

bool WorkbenchHost::inputWaits() {
    glfwPollEvents();
    return unseen_ || !keys_.empty();
}

bool WorkbenchHost::commandsWait() const {
    return !chords_.empty() || !dropped_.empty() || window_.shouldClose();
}

void WorkbenchHost::wake() {
    woken = true;
    glfwPostEmptyEvent();
}

bool WorkbenchHost::interacting() const {
    return ImGui::IsAnyMouseDown();
}

void WorkbenchHost::close() {
    glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
}

bool WorkbenchHost::takeClose() {
    const bool closes = window_.shouldClose();
    if (closes) glfwSetWindowShouldClose(window_.handle(), GLFW_FALSE);
    return closes;
}

void WorkbenchHost::toggleFullScreen() {
    GLFWwindow* handle = window_.handle();
    fullScreen_ = !fullScreen_;
    if (!fullScreen_) {
        if (GLFWmonitor* monitor = monitorOf(windowed_)) {  // the screen it was on may have gone
            windowed_ = fitOn(workAreaOf(monitor), windowed_, frame_);
        }
        glfwSetWindowMonitor(handle, nullptr, windowed_.at.x, windowed_.at.y, windowed_.size.x,
                             windowed_.size.y, GLFW_DONT_CARE);
        return;
    }
    windowed_ = placeOf(handle);
    frame_ = frameOf(handle);
    GLFWmonitor* monitor = monitorOf(windowed_);
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) {
        fullScreen_ = false;
        return;
    }
    glfwSetWindowMonitor(handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void WorkbenchHost::onKey(int key, int scancode, int action, int mods) {
    unseen_ = true;
    if (played_ || key < 0 || key > GLFW_KEY_LAST) return;
    const bool down = action != GLFW_RELEASE;
    const char* name = glfwGetKeyName(key, scancode);
    const bool prints = key == GLFW_KEY_SPACE || (name != nullptr && name[0] != '\0');
    const bool commands = (mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0;
    const bool modifier = key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
    keys_.add({down ? KeyEvent::Kind::down : KeyEvent::Kind::up, key, scancode, mods, 0,
               !modifier && (!prints || commands), ++order_});
}

void WorkbenchHost::onLetter(unsigned letter) {
    unseen_ = true;
    if (!played_) keys_.add({KeyEvent::Kind::letter, 0, 0, 0, letter, false, ++order_});
}

void WorkbenchHost::takeChord(ui::Chord chord) {
    if (chord.key != ui::Key::none && !ui::keyIsTaken(chord)) chords_.push_back(chord);
}

void WorkbenchHost::play(const PlayedInput& input) {
    played_ = input;
    unseen_ = true;
    if (input.chord) takeChord(*input.chord);
}

void WorkbenchHost::applyPlayed() {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {played_->mouse.x, played_->mouse.y};
    for (std::size_t i = 0; i < played_->down.size(); ++i) io.MouseDown[i] = played_->down[i];
    io.MouseWheel = std::exchange(played_->wheel, 0.0f);
    std::ranges::fill(io.KeysDown, false);
    const std::optional<ui::Chord> chord = std::exchange(played_->chord, {});
    io.KeyCtrl = chord && chord->ctrl;
    io.KeyShift = chord && chord->shift;
    if (chord) {
        if (const int code = codeOf(chord->key); code >= 0) io.KeysDown[code] = true;
    }
    for (const char letter : std::exchange(played_->text, {})) {
        io.AddInputCharacter(static_cast<unsigned char>(letter));
    }
}

void WorkbenchHost::onMouseButton(int button, bool down) {
    unseen_ = true;
    if (button < 0 || button > 2) return;
    double x = 0.0, y = 0.0;
    glfwGetCursorPos(window_.handle(), &x, &y);
    if (down) {
        presses_.push_back({.button = button, .at = {x, y}, .order = ++order_});
        return;
    }
    for (Press& press : presses_) {
        if (press.button != button || press.released) continue;
        press.released = true;
        if (press.shown) press.at = {x, y};
    }
}

void WorkbenchHost::onFocus() {
    unseen_ = true;
    focused_ = true;
}

void WorkbenchHost::onDrop(int count, const char** paths) {
    unseen_ = true;
    for (int i = 0; i < count; ++i) dropped_.emplace_back(paths[i]);
}

}  // namespace neph
