// resolve.comp: exposure, film curve and sRGB encoding.
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "../lib/tonemap.glsl"

layout(rgba32f, binding = 0) readonly uniform image2D i_linear;
layout(rgba8, binding = 1) writeonly uniform image2D o_display;
layout(location = 0) uniform float gain;
layout(location = 1) uniform int curve;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(i_linear)))) return;
    vec3 shown = displayValue(imageLoad(i_linear, pixel).rgb, gain, curve);
    imageStore(o_display, pixel, vec4(shown + ditherStep(pixel) / 255.0, 1.0));
}
