// phase_draine.glsl: Draine's phase function, Henyey-Greenstein times 1 + α cos²Θ. [Draine03] eq.
// 12
//
// alpha = 0 is Henyey-Greenstein, alpha = 1 Cornette-Shanks, and alpha = 1 with g = 0 Rayleigh. g
// is not the mean of cosTheta. |g| < 1, alpha >= 0. Other conventions as in phase_hg.glsl.
#pragma once
#include "phase_hg.glsl"

/// Normalisation: the integral of (1 + α cos²Θ) times the Henyey-Greenstein function.
float draineNorm(float g, float alpha) {
    return 1.0f + alpha * (1.0f + 2.0f * g * g) / 3.0f;
}

/// Phase function, 1/sr.
float draineValue(float cosTheta, float g, float alpha) {
    return hgValue(cosTheta, g) * (1.0f + alpha * cosTheta * cosTheta) / draineNorm(g, alpha);
}

/// The cumulative as a function of 1 - cosTheta; docs/physics.md §2 derives this form, which is
/// valid for every g, including 0.
float draineCumulativeOfVersine(float versine, float g, float alpha) {
    float near = 1.0f - g;
    float t = sqrt(hgDistanceSquared(versine, g));
    float b = 1.0f + g * g;
    float p = t * near;
    float c = versine / (t + near);
    float mu = 1.0f - versine;
    float d = (b * (1.0f + mu) - 2.0f * g * mu) / (b + p);
    return (1.0f - g * g) * c / p * (1.0f + alpha * (d * d + p * c * c / 3.0f)) /
           draineNorm(g, alpha);
}

/// Share of the light scattered within `theta` radians of forward, in [0, 1]; closed form.
float draineCumulative(float theta, float g, float alpha) {
    float sine = sin(0.5f * theta);
    return draineCumulativeOfVersine(2.0f * sine * sine, g, alpha);
}

/// Cosine of a direction sampled with density draineValue, from a uniform number in [0, 1).
/// Newton's method on the closed form, in the variable w = 1 - Henyey-Greenstein cumulative, in
/// which the slope (1 + α cos²Θ)/norm varies little; steps that leave the bracket are replaced by
/// bisection.
float draineSample(float u, float g, float alpha) {
    float norm = draineNorm(g, alpha);
    float lower = 0.0f;
    float upper = 1.0f;
    float w = u;
    for (int i = 0; i < 12; ++i) {
        float versine = hgVersine(w, g);
        float excess = 1.0f - draineCumulativeOfVersine(versine, g, alpha) - u;
        if (excess > 0.0f) {
            upper = w;
        } else {
            lower = w;
        }
        float mu = 1.0f - versine;
        float move = excess * norm / (1.0f + alpha * mu * mu);
        if (abs(move) < 1e-7f) break;
        float next = w - move;
        w = (next <= lower || next >= upper) ? 0.5f * (lower + upper) : next;
    }
    return hgSample(w, g);
}

/// Mean of cosTheta.
float draineAsymmetry(float g, float alpha) {
    return g * (1.0f + alpha * (3.0f + 2.0f * g * g) / 5.0f) / draineNorm(g, alpha);
}
