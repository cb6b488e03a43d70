// average.comp: squares of rays to pixels, in linear light.
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "../shared/display_layout.glsl"

layout(rgba32f, binding = kAverageRaysImage) readonly uniform image2D i_rays;
layout(rgba32f, binding = kAverageLinearImage) writeonly uniform image2D o_linear;
layout(location = kAverageSideLocation) uniform int side;  // of a square

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(o_linear)))) return;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) sum += imageLoad(i_rays, side * pixel + ivec2(x, y));
    }
    imageStore(o_linear, pixel, sum / float(side * side));
}
