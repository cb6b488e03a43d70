// context.cpp: creates contexts with EGL and GLFW, both for OpenGL 4.5 core.
#include "app/gl/context.h"

// clang-format off
#include <epoxy/gl.h>
#include <epoxy/egl.h>
// clang-format on
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/error.h"

namespace neph::gl {
namespace {

constexpr int kGlMajor = 4, kGlMinor = 5;

[[noreturn]] void fail(std::string what, std::string found, std::string hint) {
    throw Error({"", std::move(what), std::move(found), "OpenGL 4.5 core", std::move(hint)});
}

std::string eglReason() {
    return fmt::format("EGL error 0x{:x}", eglGetError());
}

std::string glfwReason() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

/// Where leaks are looked for, the driver and the window system stay loaded. What a library keeps
/// in a variable of its own counts as lost once the variable is unloaded, and is reported without a
/// name: as is Mesa's table of an AMD processor's caches (util_cpu_caps.L3_affinity_mask, 128 bytes
/// for each L3).
void keepLibrariesLoaded() {
#ifdef NEPH_SANITIZED
    std::vector<std::string> names;
    dl_iterate_phdr(
        [](dl_phdr_info* library, std::size_t, void* to) {
            static_cast<std::vector<std::string>*>(to)->emplace_back(library->dlpi_name);
            return 0;
        },
        &names);
    for (const std::string& name : names) {
        void* library = dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
        if (library != nullptr) dlclose(library);
    }
#endif
}

}  // namespace

struct HeadlessContext::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~Impl() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglTerminate(display);
    }
};

HeadlessContext::HeadlessContext() : impl_(std::make_unique<Impl>()) {
    const std::string hint = "install libegl1 and a driver, for example libgl1-mesa-dri";
    // The EXT function, because libepoxy resolves the core one through a display, and none exists
    // yet.
    impl_->display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (impl_->display == EGL_NO_DISPLAY) fail("there is no EGL display", eglReason(), hint);
    if (!eglInitialize(impl_->display, nullptr, nullptr)) {
        fail("EGL cannot be initialised", eglReason(), hint);
    }
    keepLibrariesLoaded();
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                             kGlMajor,
                             EGL_CONTEXT_MINOR_VERSION,
                             kGlMinor,
                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                             EGL_NONE};
    impl_->context = eglCreateContext(impl_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (impl_->context == EGL_NO_CONTEXT) fail("EGL provides no context", eglReason(), hint);
    if (!eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl_->context)) {
        fail("the EGL context cannot be used without a surface", eglReason(), hint);
    }
}

HeadlessContext::~HeadlessContext() = default;

Window::Window(int width, int height, const std::string& title) {
    const std::string hint = "without a display use `nephoscope render FILE --out image.png`";
    if (!glfwInit()) fail("no window can be opened", glfwReason(), hint);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, kGlMajor);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, kGlMinor);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);  // whoever places it shows it
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    keepLibrariesLoaded();
    if (!window_) {
        const std::string reason = glfwReason();
        glfwTerminate();
        fail("the window has no OpenGL 4.5", reason, hint);
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

bool Window::shouldClose() const {
    return glfwWindowShouldClose(window_) != 0;
}

void Window::swap() {
    glfwSwapBuffers(window_);
}

int Window::framebufferWidth() const {
    int width = 0;
    glfwGetFramebufferSize(window_, &width, nullptr);
    return width;
}

int Window::framebufferHeight() const {
    int height = 0;
    glfwGetFramebufferSize(window_, nullptr, &height);
    return height;
}

float Window::contentScale() const {
    float scale = 1.0f;
    glfwGetWindowContentScale(window_, &scale, nullptr);
    return scale;
}

void Window::clear(const glm::vec3& colour) {
    glViewport(0, 0, framebufferWidth(), framebufferHeight());
    glClearColor(colour.r, colour.g, colour.b, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Window::fill(const PixelBox& part, unsigned texture, glm::ivec2 sizePx, glm::vec2 widthShare) {
    const glm::ivec2 columns(glm::round(widthShare * static_cast<float>(sizePx.x)));
    GLuint frame = 0;
    glCreateFramebuffers(1, &frame);
    glNamedFramebufferTexture(frame, GL_COLOR_ATTACHMENT0, texture, 0);
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);  // image stores wrote the texture
    glBlitNamedFramebuffer(frame, 0, columns.x, 0, columns.y, sizePx.y, part.lower.x, part.lower.y,
                           part.upper.x, part.upper.y, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glDeleteFramebuffers(1, &frame);
}

std::vector<std::uint8_t> Window::readRgba() const {
    const int width = framebufferWidth(), height = framebufferHeight();
    const auto row = static_cast<std::size_t>(width) * 4;
    std::vector<std::uint8_t> upward(row * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
    // GL has row 0 at the bottom.
    std::vector<std::uint8_t> rgba;
    rgba.reserve(upward.size());
    for (int y = height; y-- > 0;) {
        const auto* from = upward.data() + row * static_cast<std::size_t>(y);
        rgba.insert(rgba.end(), from, from + row);
    }
    for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 255;
    return rgba;
}

DeviceMemory deviceMemory() {
    DeviceMemory memory;
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string_view renderer = name == nullptr ? "" : name;
    memory.software = renderer.find("llvmpipe") != renderer.npos ||
                      renderer.find("softpipe") != renderer.npos ||
                      renderer.find("SwiftShader") != renderer.npos;
    std::array<GLint, 4> kibibytes{};  // the ATI extension returns four numbers
    if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info")) {
        glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, kibibytes.data());
    } else if (epoxy_has_gl_extension("GL_ATI_meminfo")) {
        glGetIntegerv(GL_TEXTURE_FREE_MEMORY_ATI, kibibytes.data());
    }
    memory.freeBytes = static_cast<std::uint64_t>(std::max(0, kibibytes[0])) * 1024;
    return memory;
}

}  // namespace neph::gl
