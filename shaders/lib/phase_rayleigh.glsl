// phase_rayleigh.glsl: particles much smaller than the wavelength, unpolarised light. [Rayleigh71],
// [BH83] §5.1
//
// cosTheta: cosine between the propagation directions before and after scattering (1 = forward).
// Values are per steradian.
#pragma once
#include "constants.glsl"

/// Phase function, 1/sr: 3/(16π) (1 + cos²Θ).
float rayleighValue(float cosTheta) {
    return 0.75f * kInverseFourPi * (1.0f + cosTheta * cosTheta);
}

/// Share of the light scattered within `theta` radians of forward, in [0, 1].
float rayleighCumulative(float theta) {
    float mu = cos(theta);
    return 0.125f * (4.0f - mu * (3.0f + mu * mu));
}

/// Cosine of a direction sampled with density rayleighValue, from a uniform number in [0, 1): the
/// real root of μ³ + 3μ = 4 (2u - 1), by Cardano.
float rayleighSample(float u) {
    float q = abs(4.0f * u - 2.0f);
    float root = pow(q + sqrt(q * q + 1.0f), 1.0f / 3.0f);
    float mu = min(root - 1.0f / root, 1.0f);
    return u < 0.5f ? -mu : mu;
}
