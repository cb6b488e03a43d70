// workbench_host.cpp: the only file that knows both ImGui's backends and GLFW.
#include "app/workbench_host.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <array>
#include <utility>

#include "app/ui/theme.h"

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
constexpr std::array<std::pair<char, ui::Key>, 5> kSigns{{{'?', ui::Key::question},
                                                          {',', ui::Key::comma},
                                                          {'.', ui::Key::period},
                                                          {'+', ui::Key::plus},
                                                          {'-', ui::Key::minus}}};

/// The key `steps` after `first`, in the order of ui::Key.
ui::Key after(ui::Key first, int steps) {
    return static_cast<ui::Key>(static_cast<int>(first) + steps);
}

constexpr int kMinWidthPx = 900, kMinHeightPx = 480;  // both columns and a picture between them

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

WorkbenchHost& hostOf(GLFWwindow* window) {
    return *static_cast<WorkbenchHost*>(glfwGetWindowUserPointer(window));
}

}  // namespace

WorkbenchHost::WorkbenchHost(gl::Window& window) : window_(window) {
    GLFWwindow* handle = window.handle();
    glfwSetWindowUserPointer(handle, this);
    glfwSetWindowSizeLimits(handle, kMinWidthPx, kMinHeightPx, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetKeyCallback(handle, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        if (action != GLFW_RELEASE) hostOf(w).onKey(key, scancode, mods);
    });
    glfwSetMouseButtonCallback(handle, [](GLFWwindow* w, int button, int action, int) {
        hostOf(w).onMouseButton(button, action == GLFW_PRESS);
    });
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
    ui::applyTheme(window.contentScale());
    ui::loadFont(window.contentScale());
    ImGui_ImplGlfw_InitForOpenGL(handle, true);  // chains the callbacks set above
    ImGui_ImplOpenGL3_Init("#version 450");
}

WorkbenchHost::~WorkbenchHost() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void WorkbenchHost::beginFrame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    holdTappedKeys();
    replayPresses();
    ImGui::NewFrame();
}

/// ImGui looks at keys once a frame; one pressed and released between two frames counts as down for
/// the next.
void WorkbenchHost::holdTappedKeys() {
    ImGuiIO& io = ImGui::GetIO();
    for (const int key : held_) {
        io.KeysDown[key] = glfwGetKey(window_.handle(), key) == GLFW_PRESS;
    }
    for (const int key : tapped_) io.KeysDown[key] = true;
    held_ = std::exchange(tapped_, {});
}

/// Panels have the window's own colour: to blend them over a picture that they hide took a CPU that
/// stands in for a GPU longer than all that is on them.
void WorkbenchHost::endFrame(const ui::PixelBox& place, unsigned picture, glm::ivec2 sizePx) {
    ImGui::Render();
    const ImVec4& colour = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
    window_.clear({colour.x, colour.y, colour.z});
    if (picture != 0) window_.fill(place.lower, place.upper, picture, sizePx);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    window_.swap();
}

/// ImGui looks at the mouse once a frame, too. After a slow frame it is shown where a button went
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

void WorkbenchHost::wait(double seconds) {
    if (inputSeen_) seconds = 0.0;
    inputSeen_ = false;
    if (seconds > 0.0 && presses_.empty()) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
}

bool WorkbenchHost::inputWaits() {
    glfwPollEvents();
    return inputSeen_;
}

void WorkbenchHost::wake() {
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
        glfwSetWindowMonitor(handle, nullptr, windowed_.x, windowed_.y, windowed_.z, windowed_.w,
                             GLFW_DONT_CARE);
        return;
    }
    glfwGetWindowPos(handle, &windowed_.x, &windowed_.y);
    glfwGetWindowSize(handle, &windowed_.z, &windowed_.w);
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) {
        fullScreen_ = false;
        return;
    }
    glfwSetWindowMonitor(handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void WorkbenchHost::onKey(int key, int scancode, int mods) {
    inputSeen_ = true;
    if (key >= 0 && key <= GLFW_KEY_LAST) tapped_.push_back(key);
    // What is typed into a field is not a command; a control chord still is, unless it edits text.
    const bool ctrl = (mods & GLFW_MOD_CONTROL) != 0;
    const ui::Key named = toKey(key, scancode);
    const bool editsText = named == ui::Key::z || named == ui::Key::y;
    if (ImGui::GetIO().WantTextInput && (!ctrl || editsText)) return;
    if (named != ui::Key::none) {
        chords_.push_back({named, ctrl, (mods & GLFW_MOD_SHIFT) != 0});
    }
}

void WorkbenchHost::onMouseButton(int button, bool down) {
    inputSeen_ = true;
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
    inputSeen_ = true;
    focused_ = true;
}

void WorkbenchHost::onDrop(int count, const char** paths) {
    inputSeen_ = true;
    for (int i = 0; i < count; ++i) dropped_.emplace_back(paths[i]);
}

}  // namespace neph
