// resolve.comp: the sun's glare in the lens, exposure, tone mapping and sRGB encoding.
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "../lib/sun_disc.glsl"
#include "../lib/tonemap.glsl"
#include "../shared/display_layout.glsl"

layout(rgba32f, binding = kResolveLinearImage) readonly uniform image2D i_linear;
layout(rgba8, binding = kResolveDisplayImage) writeonly uniform image2D o_display;
layout(r32f, binding = kResolveSunShownImage) readonly uniform image2D i_sunShown;
layout(location = kResolveExposureLocation) uniform mat3 exposure;  // and white balance
layout(location = kResolveCurveLocation) uniform int curve;
layout(location = kResolveLeftLocation) uniform int left;  // of this part in the whole image
layout(location = kResolveLowerLocation) uniform int lower;
layout(location = kResolveTransparentLocation) uniform int transparent;

layout(location = kResolveGlareLocation) uniform vec3 glare;  // of all of the disc
// Of the eye, as FrameBlock has them.
layout(location = kResolveForwardLocation) uniform vec3 forward;
layout(location = kResolveRightLocation) uniform vec3 right;
layout(location = kResolveUpLocation) uniform vec3 up;
layout(location = kResolveTowardsSunLocation) uniform vec3 towardsSun;
layout(location = kResolveWholeLocation) uniform ivec2 whole;  // size of the whole image

vec3 strayLight(ivec2 pixel) {
    if (glare.g <= 0.0) return vec3(0.0);
    vec2 ndc = 2.0 * (vec2(pixel + ivec2(left, lower)) + 0.5) / vec2(whole) - 1.0;
    vec3 dir = normalize(forward + ndc.x * right + ndc.y * up);
    return imageLoad(i_sunShown, ivec2(0)).r * glare *
           glareAt(acos(clamp(dot(dir, towardsSun), -1.0, 1.0)));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(i_linear)))) return;
    vec4 seen = imageLoad(i_linear, pixel);
    vec3 exposed = exposure * (seen.rgb + strayLight(pixel));
    float opacity = transparent == 1 ? seen.a : 1.0;
    vec3 shown =
        transparent == 1 ? straightValue(exposed, curve, opacity) : displayValue(exposed, curve);
    vec3 dithered = shown + ditherStep(pixel + ivec2(left, lower)) / 255.0;
    imageStore(o_display, pixel, vec4(dithered, opacity));
}
