// objects.h: move-only owners of GL objects. The context that created an object must be current
// when it is destroyed.
#pragma once
#include <epoxy/gl.h>

#include <cstddef>
#include <glm/glm.hpp>
#include <utility>

namespace neph::gl {

/// A texture with immutable storage; nearest filter and clamped edges unless set otherwise.
/// Creation throws Error if the GPU has no memory left.
class Texture {
  public:
    Texture() = default;
    static Texture make2D(GLenum format, glm::ivec2 size);
    static Texture make2DArray(GLenum format, glm::ivec2 size, int layers);
    static Texture make3D(GLenum format, glm::ivec3 size, int levels = 1);
    ~Texture() { release(); }
    Texture(Texture&& other) noexcept { *this = std::move(other); }
    Texture& operator=(Texture&& other) noexcept;
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }
    glm::ivec3 size() const { return size_; }
    std::size_t bytes() const { return bytes_; }

    void setLinear();
    void setRepeat();
    /// Whether it repeats along its first two axes; along the third it does not.
    void setRepeatAcross(bool repeats);
    /// Replaces all texels of one level; level n + 1 has half the size of level n. `data` is
    /// tightly packed.
    void upload(GLenum pixelFormat, GLenum type, const void* data, int level = 0);
    void bind(GLuint unit) const { glBindTextureUnit(unit, name_); }
    void bindImage(GLuint unit, GLenum access) const;

  private:
    static Texture make(GLenum target, GLenum format, glm::ivec3 size, int levels);
    void release();

    GLuint name_ = 0;
    GLenum target_ = 0, format_ = 0;
    glm::ivec3 size_{0};
    std::size_t bytes_ = 0;
};

/// A buffer, created at the first write.
class Buffer {
  public:
    Buffer() = default;
    ~Buffer() { release(); }
    Buffer(Buffer&& other) noexcept { *this = std::move(other); }
    Buffer& operator=(Buffer&& other) noexcept;
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    GLuint name() const { return name_; }
    std::size_t bytes() const { return bytes_; }
    /// Replaces the contents from the start; a buffer that is too small is replaced by a larger
    /// one.
    void write(const void* data, std::size_t bytes);
    void bind(GLenum target, GLuint unit) const { glBindBufferBase(target, unit, name_); }

  private:
    void release();

    GLuint name_ = 0;
    std::size_t bytes_ = 0;
};

}  // namespace neph::gl
