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
#include <utility>

#include "app/ui/widgets/theme.h"

namespace neph {
namespace {

constexpr std::array<std::pair<int, ui::Key>, 15> kOthers{{{GLFW_KEY_LEFT, ui::Key::left},
                                                           {GLFW_KEY_RIGHT, ui::Key::right},
                                                           {GLFW_KEY_UP, ui::Key::up},
                                                           {GLFW_KEY_DOWN, ui::Key::down},
                                                           {GLFW_KEY_HOME, ui::Key::home},
                                                           {GLFW_KEY_END, ui::Key::end},
                                                           {GLFW_KEY_PAGE_UP, ui::Key::pageUp},
                                                           {GLFW_KEY_PAGE_DOWN, ui::Key::pageDown},
                                                           {GLFW_KEY_ESCAPE, ui::Key::escape},
                                                           {GLFW_KEY_TAB, ui::Key::tab},
                                                           {GLFW_KEY_SPACE, ui::Key::space},
                                                           {GLFW_KEY_ENTER, ui::Key::enter},
                                                           {GLFW_KEY_DELETE, ui::Key::remove},
                                                           {GLFW_KEY_KP_ADD, ui::Key::plus},
                                                           {GLFW_KEY_KP_SUBTRACT, ui::Key::minus}}};
constexpr std::array<std::pair<char, ui::Key>, 7> kSigns{{{'?', ui::Key::question},
                                                          {'/', ui::Key::question},
                                                          {'=', ui::Key::plus},
                                                          {',', ui::Key::comma},
                                                          {'.', ui::Key::period},
                                                          {'+', ui::Key::plus},
                                                          {'-', ui::Key::minus}}};

std::atomic<bool> woken = false;  // since the last wait

/// The key `steps` after `first`, in the order of ui::Key.
ui::Key after(ui::Key first, int steps) {
    return static_cast<ui::Key>(static_cast<int>(first) + steps);
}

constexpr glm::ivec2 kLeastPx{960, 600};  // both columns and an image between them

ui::Key toKey(int key, int scancode) {
    for (const auto& [code, named] : kOthers) {
        if (code == key) return named;
    }
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return after(ui::Key::f1, key - GLFW_KEY_F1);
    // Letters and signs go by what is printed on the key, so that Ctrl+Z is where the layout has
    // it.
    const char* name = glfwGetKeyName(key, scancode);
    if (name == nullptr || name[0] == '\0' || name[1] != '\0') return ui::Key::none;
    const char sign = name[0];
    if (sign >= 'a' && sign <= 'z') return after(ui::Key::a, sign - 'a');
    if (sign >= '0' && sign <= '9') return after(ui::Key::n0, sign - '0');
    for (const auto& [printed, named] : kSigns) {
        if (printed == sign) return named;
    }
    return ui::Key::none;
}

/// The window system's key; -1 where it has none of its own.
int toCode(ui::Key key) {
    const int at = static_cast<int>(key);
    const auto among = [at](ui::Key first, ui::Key last) {
        return at >= static_cast<int>(first) && at <= static_cast<int>(last);
    };
    const auto from = [at](int code, ui::Key first) { return code + at - static_cast<int>(first); };
    if (among(ui::Key::a, ui::Key::z)) return from(GLFW_KEY_A, ui::Key::a);
    if (among(ui::Key::n0, ui::Key::n9)) return from(GLFW_KEY_0, ui::Key::n0);
    if (among(ui::Key::f1, ui::Key::f12)) return from(GLFW_KEY_F1, ui::Key::f1);
    for (const auto& [code, named] : kOthers) {
        if (named == key) return code;
    }
    return -1;
}

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

WorkbenchHost::WorkbenchHost(gl::Window& window) : window_(window) {
    GLFWwindow* handle = window.handle();
    glfwSetWindowUserPointer(handle, this);
    glfwSetKeyCallback(handle, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        if (action != GLFW_RELEASE) hostOf(w).onKey(key, scancode, mods);
    });
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
    ImGui_ImplOpenGL3_Init("#version 450");
    fitToScreen(false);  // the window system finds a place for a new window, if it is not too large
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
    holdTappedKeys();
    if (played_) {
        applyPlayed();
    } else {
        replayPresses();
    }
    ImGui::NewFrame();
}

/// ImGui looks at keys once per frame; one pressed and released between two frames counts as down
/// for the next.
void WorkbenchHost::holdTappedKeys() {
    ImGuiIO& io = ImGui::GetIO();
    for (const int key : held_) {
        io.KeysDown[key] = glfwGetKey(window_.handle(), key) == GLFW_PRESS;
    }
    for (const int key : tapped_) io.KeysDown[key] = true;
    held_ = std::exchange(tapped_, {});
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

/// ImGui looks at the mouse once per frame, too. After a slow frame it is shown where a button went
/// down, and in the next frame where it came up, so that no click goes astray.
void WorkbenchHost::replayPresses() {
    if (presses_.empty()) return;
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
    if (unseen_ || !presses_.empty()) seconds = 0.0;
    if (seconds > 0.0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
    return woken.exchange(false) || unseen_ || !presses_.empty();
}

bool WorkbenchHost::inputWaits() {
    glfwPollEvents();
    return unseen_;
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

void WorkbenchHost::onKey(int key, int scancode, int mods) {
    unseen_ = true;
    if (key >= 0 && key <= GLFW_KEY_LAST) tapped_.push_back(key);
    if (played_) return;
    const ui::Key named = toKey(key, scancode);
    // Shift belongs to a sign: '?' is above '/', and '+' above '=' on many keyboards.
    const bool sign = named >= ui::Key::question && named <= ui::Key::minus;
    takeChord({named, (mods & GLFW_MOD_CONTROL) != 0, !sign && (mods & GLFW_MOD_SHIFT) != 0});
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
        if (const int code = toCode(chord->key); code >= 0) io.KeysDown[code] = true;
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
        presses_.push_back({button, {x, y}});
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
