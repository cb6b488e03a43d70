// binding_check.h: whether what a program reads and writes can all be bound at once.
#pragma once
#include <epoxy/gl.h>

#include <string>

namespace neph::gl {

/// Names two textures, two images or two buffers of a linked program that share a binding point,
/// "t_a and t_b, both 3"; empty where there are none.
std::string sharedBinding(GLuint program);

}  // namespace neph::gl
