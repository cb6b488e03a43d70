// phase_cornette_shanks.glsl: Henyey-Greenstein with the correct Rayleigh limit. [CS92] eq. 7
//
// g is the parameter of the formula, not the mean of cosTheta: 0.80765 gives 0.85. Draine's
// function with alpha = 1. Conventions as in phase_hg.glsl.
#pragma once
#include "phase_draine.glsl"

/// Phase function, 1/sr.
float cornetteShanksValue(float cosTheta, float g) {
    return draineValue(cosTheta, g, 1.0f);
}

/// Share of the light scattered within `theta` radians of forward, in [0, 1]; closed form.
float cornetteShanksCumulative(float theta, float g) {
    return draineCumulative(theta, g, 1.0f);
}

/// Cosine of a direction sampled with density cornetteShanksValue, from a uniform number in [0, 1).
float cornetteShanksSample(float u, float g) {
    return draineSample(u, g, 1.0f);
}

/// Mean of cosTheta: 3 g (4 + g²) / (5 (2 + g²)). [CS92] eq. 9
float cornetteShanksAsymmetry(float g) {
    return draineAsymmetry(g, 1.0f);
}
