// binding_check.cpp: asks the driver for what is active in the program.
#include "app/gl/binding_check.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace neph::gl {
namespace {

/// Name of each binding point's user.
using Users = std::map<GLint, std::string>;

std::string nameOf(GLuint program, GLenum interface, GLuint index) {
    std::array<char, 256> name{};
    glGetProgramResourceName(program, interface, index, name.size(), nullptr, name.data());
    return name.data();
}

GLint countOf(GLuint program, GLenum interface) {
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    return count;
}

std::string claim(Users& users, GLint binding, const std::string& name) {
    const auto [user, free] = users.emplace(binding, name);
    return free ? "" : fmt::format("{} and {}, both {}", user->second, name, binding);
}

/// The ranges of the OpenGL registry.
bool isImage(GLint type) {
    return type >= GL_IMAGE_1D && type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY;
}

bool isSampler(GLint type) {
    return (type >= GL_SAMPLER_1D && type <= GL_SAMPLER_2D_RECT_SHADOW) ||
           (type >= GL_SAMPLER_1D_ARRAY && type <= GL_SAMPLER_CUBE_SHADOW) ||
           (type >= GL_INT_SAMPLER_1D && type <= GL_UNSIGNED_INT_SAMPLER_BUFFER);
}

std::string sharedUnit(GLuint program) {
    constexpr std::array<GLenum, 3> kAsked{GL_TYPE, GL_LOCATION, GL_ARRAY_SIZE};
    Users textures, images;
    for (GLint i = 0; i < countOf(program, GL_UNIFORM); ++i) {
        const auto index = static_cast<GLuint>(i);
        std::array<GLint, kAsked.size()> answers{};
        glGetProgramResourceiv(program, GL_UNIFORM, index, kAsked.size(), kAsked.data(),
                               answers.size(), nullptr, answers.data());
        const auto [type, location, elements] = answers;
        if (!isImage(type) && !isSampler(type)) continue;
        for (GLint element = 0; element < elements; ++element) {
            GLint unit = 0;
            glGetUniformiv(program, location + element, &unit);
            const std::string shared =
                claim(isImage(type) ? images : textures, unit, nameOf(program, GL_UNIFORM, index));
            if (!shared.empty()) return shared;
        }
    }
    return {};
}

std::string sharedBuffer(GLuint program, GLenum interface) {
    constexpr GLenum kAsked = GL_BUFFER_BINDING;
    Users blocks;
    for (GLint i = 0; i < countOf(program, interface); ++i) {
        const auto index = static_cast<GLuint>(i);
        GLint binding = 0;
        glGetProgramResourceiv(program, interface, index, 1, &kAsked, 1, nullptr, &binding);
        const std::string shared = claim(blocks, binding, nameOf(program, interface, index));
        if (!shared.empty()) return shared;
    }
    return {};
}

}  // namespace

std::string sharedBinding(GLuint program) {
    std::string shared = sharedUnit(program);
    if (shared.empty()) shared = sharedBuffer(program, GL_UNIFORM_BLOCK);
    if (shared.empty()) shared = sharedBuffer(program, GL_SHADER_STORAGE_BLOCK);
    return shared;
}

}  // namespace neph::gl
