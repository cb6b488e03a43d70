// tonemap.glsl: from scene-referred linear radiance to display values.
#pragma once
#include "constants.glsl"

/// Filmic tone mapping, with toe and shoulder, per channel: maps 0 to 0, and large values
/// towards 1. Fit of the ACES reference by [Narkowicz15].
vec3 filmic(vec3 x) {
    vec3 y = (x * (2.51f * x + 0.03f)) / (x * (2.43f * x + 0.59f) + 0.14f);
    return clamp(y, vec3(0.0f), vec3(1.0f));
}

/// sRGB encoding of linear values in [0, 1]. IEC 61966-2-1
float srgbEncode(float x) {
    return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}

/// AgX: a sigmoid over the logarithm of radiance, 10 stops below middle grey to 6.5 above, between
/// primaries that are drawn in and out again, so that what is bright loses its colour.
/// [Sobotka22], by the polynomial of [Wrensch23].
vec3 agx(vec3 radiance) {
    const float kFirstStop = -12.47393f, kLastStop = 4.026069f;
    mat3 inwards = mat3(0.842479062f, 0.042328242f, 0.042375655f, 0.0784336f, 0.878468636f,
                        0.0784336f, 0.079223745f, 0.079166127f, 0.879142974f);
    mat3 outwards = mat3(1.196879005f, -0.052896852f, -0.052971636f, -0.098020881f, 1.15190313f,
                         -0.09804345f, -0.099029744f, -0.098961177f, 1.151073673f);
    vec3 stops = log2(max(inwards * radiance, vec3(1e-10f)));
    vec3 x = clamp((stops - kFirstStop) / (kLastStop - kFirstStop), vec3(0.0f), vec3(1.0f));
    vec3 x2 = x * x;
    vec3 x4 = x2 * x2;
    vec3 y = 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x + 0.4298f * x2 +
             0.1191f * x - 0.00232f;
    // More contrast and colour than the base has, near its look called "punchy".
    y = pow(max(y, vec3(0.0f)), vec3(1.35f));
    y = mix(vec3(dot(y, kLuminance)), y, 1.25f);
    vec3 encoded = clamp(outwards * y, vec3(0.0f), vec3(1.0f));
    return pow(encoded, vec3(2.2f));
}

/// Linear display value, 1 for white, of a linear radiance as it is exposed and balanced. `curve`
/// is 0 for linear, 1 for filmic, 2 for AgX.
vec3 displayShare(vec3 radiance, int curve) {
    vec3 exposed = max(radiance, vec3(0.0f));
    if (curve == 2) return agx(exposed);
    return curve == 1 ? filmic(exposed) : clamp(exposed, vec3(0.0f), vec3(1.0f));
}

/// Encoded display value of the same.
vec3 displayValue(vec3 radiance, int curve) {
    vec3 share = displayShare(radiance, curve);
    return vec3(srgbEncode(share.r), srgbEncode(share.g), srgbEncode(share.b));
}

/// Colour that looks the same when it is composited over black with `opacity` in linear light, as
/// far as that is possible: no colour is brighter than white.
vec3 straightValue(vec3 radiance, int curve, float opacity) {
    vec3 share = displayShare(radiance, curve);
    share = min(share / max(opacity, 1e-6f), vec3(1.0f));
    return vec3(srgbEncode(share.r), srgbEncode(share.g), srgbEncode(share.b));
}

/// Ordered noise, in (-1/2, 1/2) of a display step, so that slow gradients show no bands in 8 bits.
/// [Jimenez14] slide 123
float ditherStep(ivec2 pixel) {
    return fract(52.9829189f * fract(0.06711056f * float(pixel.x) + 0.00583715f * float(pixel.y))) -
           0.5f;
}
