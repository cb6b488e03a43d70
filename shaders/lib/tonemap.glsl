// tonemap.glsl: from scene-referred linear radiance to display values.
#pragma once

/// Film-like curve with toe and shoulder, per channel; 0 to 0, large to 1. Fit of the ACES
/// reference by [Narkowicz15].
vec3 filmic(vec3 x) {
    vec3 y = (x * (2.51f * x + 0.03f)) / (x * (2.43f * x + 0.59f) + 0.14f);
    return clamp(y, vec3(0.0f), vec3(1.0f));
}

/// Linear [0, 1] to sRGB. IEC 61966-2-1.
float srgbEncode(float x) {
    return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}

/// Share of the display's white, linear, of a linear radiance: gain, curve (0 linear, 1 filmic).
vec3 displayShare(vec3 radiance, float gain, int curve) {
    vec3 exposed = max(radiance * gain, vec3(0.0f));
    return curve == 1 ? filmic(exposed) : clamp(exposed, vec3(0.0f), vec3(1.0f));
}

/// Display value of a linear radiance.
vec3 displayValue(vec3 radiance, float gain, int curve) {
    vec3 share = displayShare(radiance, gain, curve);
    return vec3(srgbEncode(share.r), srgbEncode(share.g), srgbEncode(share.b));
}

/// Colour that shows the same when `opacity` of it is put over black in linear light, where that
/// can be: no colour is brighter than white.
vec3 straightValue(vec3 radiance, float gain, int curve, float opacity) {
    vec3 share = displayShare(radiance, gain, curve);
    share = min(share / max(opacity, 1e-6f), vec3(1.0f));
    return vec3(srgbEncode(share.r), srgbEncode(share.g), srgbEncode(share.b));
}

/// Ordered noise in (-1/2, 1/2) of a display step, so that a slow gradient shows no bands in 8
/// bits. [Jimenez14] slide 123
float ditherStep(ivec2 pixel) {
    return fract(52.9829189f * fract(0.06711056f * float(pixel.x) + 0.00583715f * float(pixel.y))) -
           0.5f;
}
