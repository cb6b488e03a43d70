// phase_double_hg.glsl: a forward and a backward Henyey-Greenstein lobe. [Irvine65]
//
// weight: share of the first lobe, in [0, 1]. Other conventions as in phase_hg.glsl.
#pragma once
#include "phase_hg.glsl"

/// Phase function, 1/sr.
float doubleHgValue(float cosTheta, float g1, float g2, float weight) {
    return mix(hgValue(cosTheta, g2), hgValue(cosTheta, g1), weight);
}

/// Share of the light scattered within `theta` radians of forward, in [0, 1].
float doubleHgCumulative(float theta, float g1, float g2, float weight) {
    return mix(hgCumulative(theta, g2), hgCumulative(theta, g1), weight);
}

/// Cosine of a direction sampled with density doubleHgValue, from a uniform number in [0, 1), which
/// first chooses the lobe.
float doubleHgSample(float u, float g1, float g2, float weight) {
    if (u < weight) return hgSample(u / weight, g1);
    return hgSample((u - weight) / (1.0f - weight), g2);
}

/// Mean of cosTheta.
float doubleHgAsymmetry(float g1, float g2, float weight) {
    return mix(g2, g1, weight);
}
