// phase_hg.glsl: the Henyey-Greenstein phase function. [HG41]
//
// cosTheta: cosine between the propagation directions before and after scattering (1 = forward).
// Values are per steradian and integrate to 1 over the sphere. |g| < 1; g is the mean of cosTheta.
// The forms below have no 1/g, so g = 0 needs no special case.
#pragma once
#include "constants.glsl"

/// 1 + g² - 2 g cosTheta, free of cancellation near forward; `versine` is 1 - cosTheta.
float hgDistanceSquared(float versine, float g) {
    return (1.0f - g) * (1.0f - g) + 2.0f * g * versine;
}

/// Phase function, 1/sr.
float hgValue(float cosTheta, float g) {
    float s = hgDistanceSquared(1.0f - cosTheta, g);
    return kInverseFourPi * (1.0f - g * g) / (s * sqrt(s));
}

/// Share of the light scattered within `theta` radians of forward, in [0, 1]; closed form.
float hgCumulative(float theta, float g) {
    float sine = sin(0.5f * theta);
    float versine = 2.0f * sine * sine;
    float t = sqrt(hgDistanceSquared(versine, g));
    return (1.0f - g * g) * versine / (t * (1.0f - g) * (t + 1.0f - g));
}

/// 1 - cosTheta of the angle outside which the share `u` of the light is scattered; u = 1 is
/// forward.
float hgVersine(float u, float g) {
    float q = 1.0f - g + 2.0f * g * u;
    return (1.0f - u) * (1.0f - g) * ((1.0f - g * g) / q + 1.0f - g) / q;
}

/// Cosine of a direction sampled with density hgValue, from a uniform number in [0, 1).
float hgSample(float u, float g) {
    return 1.0f - hgVersine(u, g);
}
