// cosines.comp: cosines of scattering angles as paths draw them, to be tested.
#version 450 core
layout(local_size_x = 64) in;
#include "../lib/random.glsl"
#include "../shared/reference_layout.glsl"
#include "scattering.glsl"

layout(std430, binding = kCosinesBuffer) writeonly buffer Cosines {
    float cosines_[];
};
layout(location = kCosinesCountLocation) uniform int count;
layout(location = kCosinesSeedLocation) uniform int seed;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(count)) return;
    float u = unitsOf(randomWords(uvec4(i, 0u, 0u, seed))).x;
    cosines_[i] = 1.0 - drawVersine(0, 1, u).x;
}
