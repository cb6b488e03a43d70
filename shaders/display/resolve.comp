// resolve.comp: exposure, tone mapping and sRGB encoding.
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "../lib/tonemap.glsl"
#include "../shared/display_layout.glsl"

layout(rgba32f, binding = kResolveLinearImage) readonly uniform image2D i_linear;
layout(rgba8, binding = kResolveDisplayImage) writeonly uniform image2D o_display;
layout(location = kResolveGainLocation) uniform float gain;
layout(location = kResolveCurveLocation) uniform int curve;
layout(location = kResolveLeftLocation) uniform int left;  // of this part in the whole image
layout(location = kResolveLowerLocation) uniform int lower;
layout(location = kResolveTransparentLocation) uniform int transparent;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(i_linear)))) return;
    vec4 seen = imageLoad(i_linear, pixel);
    float opacity = transparent == 1 ? seen.a : 1.0;
    vec3 shown = transparent == 1 ? straightValue(seen.rgb, gain, curve, opacity)
                                  : displayValue(seen.rgb, gain, curve);
    vec3 dithered = shown + ditherStep(pixel + ivec2(left, lower)) / 255.0;
    imageStore(o_display, pixel, vec4(dithered, opacity));
}
