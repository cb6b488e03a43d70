// phase_isotropic.glsl: equal scattering in every direction.
//
// cosTheta: cosine between the propagation directions before and after scattering (1 = forward).
// Values are per steradian.
#pragma once
#include "constants.glsl"

/// Phase function, 1/sr.
float isotropicValue() {
    return kInverseFourPi;
}

/// Share of the light scattered within `theta` radians of forward, in [0, 1].
float isotropicCumulative(float theta) {
    return 0.5f * (1.0f - cos(theta));
}

/// Cosine of a direction sampled with density isotropicValue, from a uniform number in [0, 1).
float isotropicSample(float u) {
    return 2.0f * u - 1.0f;
}
