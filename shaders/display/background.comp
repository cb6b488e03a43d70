// background.comp: puts sky and ground behind the eye buffer of the slices: T L_bg of Eq. 5.
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "../shared/display_layout.glsl"
#include "backdrop.glsl"

layout(rgba32f, binding = kBackgroundEyeImage) readonly uniform image2D i_eye;
layout(rgba32f, binding = kBackgroundLinearImage) writeonly uniform image2D o_linear;
layout(location = kBackgroundLayerLocation) uniform int lastLayer;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, u_.image.xy))) return;
    vec3 behind = backdrop(rayThrough(pixel), lastLayer, 1.0);
    vec4 eye = imageLoad(i_eye, pixel);
    imageStore(o_linear, pixel, vec4(eye.rgb + eye.a * behind, 1.0 - eye.a));
}
