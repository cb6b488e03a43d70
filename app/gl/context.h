// context.h: creates an OpenGL 4.5 core context, without a display (EGL surfaceless) or in a GLFW
// window.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/grid/boxes.h"

struct GLFWwindow;

namespace neph::gl {

/// EGL context without a surface, current in the creating thread while the object lives. Throws
/// Error if the system provides none.
class HeadlessContext {
  public:
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// A GLFW window whose context is current. Throws Error if there is no display.
class Window {
  public:
    /// Not shown yet: its place depends on the screen.
    Window(int width, int height, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    bool shouldClose() const;
    /// Shows what was drawn.
    void swap();
    int framebufferWidth() const;
    int framebufferHeight() const;
    /// Content scale of the monitor: 1 for 96 dpi.
    float contentScale() const;
    /// Clears the window's framebuffer.
    void clear(const glm::vec3& colour);
    /// Fills a part of the framebuffer, interpolated, with a 2D texture of `sizePx`, or with its
    /// columns between two fractions of its width. Both have row 0 at the bottom.
    void fill(const PixelBox& part, unsigned texture, glm::ivec2 sizePx,
              glm::vec2 widthShare = {0.0f, 1.0f});
    /// What was drawn since the last swap: sRGB with an alpha of 255, row 0 at the top.
    std::vector<std::uint8_t> readRgba() const;

  private:
    GLFWwindow* window_ = nullptr;
};

/// Memory for textures and buffers of the current context's device.
struct DeviceMemory {
    bool software = false;        ///< a software renderer, which uses the machine's main memory
    std::uint64_t freeBytes = 0;  ///< 0 if the driver does not report it
};
DeviceMemory deviceMemory();

}  // namespace neph::gl
