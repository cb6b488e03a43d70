// glsl_cpp.h: the shader library as C++, so that tests and core call the same code that runs on the
// GPU.
//
// Include this only from .cpp files: each gets its own copy in an unnamed namespace. GLM supplies
// the vector types and the built-in functions. Add new files of shaders/lib to the list below.
#pragma once
#include <glm/glm.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // no file calls all of the library

namespace neph::glsl {
namespace {
using namespace glm;

#include "shaders/lib/constants.glsl"
#include "shaders/lib/directions.glsl"
#include "shaders/lib/ground.glsl"
#include "shaders/lib/harmonics.glsl"
#include "shaders/lib/noise.glsl"
#include "shaders/lib/optics.glsl"
#include "shaders/lib/phase_cornette_shanks.glsl"
#include "shaders/lib/phase_double_hg.glsl"
#include "shaders/lib/phase_draine.glsl"
#include "shaders/lib/phase_hg.glsl"
#include "shaders/lib/phase_ice.glsl"
#include "shaders/lib/phase_isotropic.glsl"
#include "shaders/lib/phase_rayleigh.glsl"
#include "shaders/lib/phase_table.glsl"
#include "shaders/lib/random.glsl"
#include "shaders/lib/ray_box.glsl"
#include "shaders/lib/scattering_table.glsl"
#include "shaders/lib/sky.glsl"
#include "shaders/lib/sky_table.glsl"
#include "shaders/lib/sun_disc.glsl"
#include "shaders/lib/tonemap.glsl"

}  // namespace
}  // namespace neph::glsl

#pragma GCC diagnostic pop
