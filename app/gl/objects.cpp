// objects.cpp: creates, fills and deletes GL objects by direct state access.
#include "app/gl/objects.h"

#include <fmt/format.h>

#include <cassert>

#include "core/base/error.h"

namespace neph::gl {
namespace {

/// Only the formats that this program uses.
std::size_t bytesPerTexel(GLenum format) {
    switch (format) {
        case GL_RGBA32F:
            return 16;
        case GL_RGBA16:
        case GL_RGBA16F:
        case GL_RG32F:
            return 8;
        case GL_R32F:
        case GL_R32UI:
        case GL_RGBA8:
        case GL_RG16:
        case GL_RG16F:
            return 4;
        case GL_R16:
        case GL_R16F:
        case GL_RG8:
            return 2;
        case GL_R8:
        case GL_R8UI:
            return 1;
        default:
            break;
    }
    assert(!"format of unknown size");
    return 0;
}

}  // namespace

Texture Texture::make(GLenum target, GLenum format, glm::ivec3 size, int levels) {
    Texture texture;
    glCreateTextures(target, 1, &texture.name_);
    texture.target_ = target;
    texture.format_ = format;
    texture.size_ = size;
    texture.bytes_ = bytesPerTexel(format) * static_cast<std::size_t>(size.x) *
                     static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
    if (target == GL_TEXTURE_2D) {
        glTextureStorage2D(texture.name_, levels, format, size.x, size.y);
    } else {
        glTextureStorage3D(texture.name_, levels, format, size.x, size.y, size.z);
    }
    if (glGetError() == GL_OUT_OF_MEMORY) {
        throw Error({.what = "the GPU has not enough memory for a texture",
                     .found = fmt::format("{} x {} x {}, {} MiB", size.x, size.y, size.z,
                                          texture.bytes_ >> 20),
                     .hint = "render a smaller image, or use fewer planes"});
    }
    glTextureParameteri(texture.name_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture.name_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTextureParameteri(texture.name_, axis, GL_CLAMP_TO_EDGE);
    }
    return texture;
}

Texture Texture::make2D(GLenum format, glm::ivec2 size) {
    return make(GL_TEXTURE_2D, format, {size, 1}, 1);
}
Texture Texture::make2DArray(GLenum format, glm::ivec2 size, int layers) {
    return make(GL_TEXTURE_2D_ARRAY, format, {size, layers}, 1);
}
Texture Texture::make3D(GLenum format, glm::ivec3 size, int levels) {
    return make(GL_TEXTURE_3D, format, size, levels);
}

Texture& Texture::operator=(Texture&& other) noexcept {
    if (this != &other) {
        release();
        name_ = std::exchange(other.name_, 0);
        target_ = other.target_;
        format_ = other.format_;
        size_ = std::exchange(other.size_, glm::ivec3(0));
        bytes_ = std::exchange(other.bytes_, std::size_t{0});
    }
    return *this;
}

void Texture::release() {
    if (name_ != 0) glDeleteTextures(1, &name_);
    name_ = 0;
}

void Texture::setLinear() {
    glTextureParameteri(name_, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void Texture::setRepeat() {
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTextureParameteri(name_, axis, GL_REPEAT);
    }
}

void Texture::setRepeatAcross(bool repeats) {
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
        glTextureParameteri(name_, axis, repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    }
}

void Texture::upload(GLenum pixelFormat, GLenum type, const void* data, int level) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const glm::ivec3 size = glm::max(size_ >> level, glm::ivec3(1));
    if (target_ == GL_TEXTURE_2D) {
        glTextureSubImage2D(name_, level, 0, 0, size.x, size.y, pixelFormat, type, data);
    } else {
        glTextureSubImage3D(name_, level, 0, 0, 0, size.x, size.y, size.z, pixelFormat, type, data);
    }
}

void Texture::bindImage(GLuint unit, GLenum access) const {
    glBindImageTexture(unit, name_, 0, GL_TRUE, 0, access, format_);
}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    if (this != &other) {
        release();
        name_ = std::exchange(other.name_, 0);
        bytes_ = std::exchange(other.bytes_, std::size_t{0});
    }
    return *this;
}

void Buffer::release() {
    if (name_ != 0) glDeleteBuffers(1, &name_);
    name_ = 0;
}

void Buffer::write(const void* data, std::size_t bytes) {
    if (bytes_ < bytes) {
        release();
        glCreateBuffers(1, &name_);
        glNamedBufferStorage(name_, static_cast<GLsizeiptr>(bytes), nullptr,
                             GL_DYNAMIC_STORAGE_BIT);
        bytes_ = bytes;
    }
    glNamedBufferSubData(name_, 0, static_cast<GLsizeiptr>(bytes), data);
}

}  // namespace neph::gl
