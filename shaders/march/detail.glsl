// detail.glsl: the detail that samples along a ray add to the medium.
#pragma once
#include "../lib/noise.glsl"
#include "packed_sample.glsl"

#if NOISE
// A tile of billow, and of wisp upon it; nearest.
layout(binding = kNoiseUnit) uniform sampler3D t_noise;
// Classes with detail of one scale and character share a kind.
const int kKindOfClass[CLASSES] = KIND_OF_CLASS;
const int kClassOfKind[KINDS] = CLASS_OF_KIND;

/// Shares of the kinds of detail in a mixture, and shares times amounts.
struct Detail {
    float share[KINDS];
    float amount[KINDS];
};

Detail detailOf(Mixture mixture) {
    Detail detail;
    for (int k = 0; k < KINDS; ++k) {
        detail.share[k] = 0.0;
        detail.amount[k] = 0.0;
    }
    for (int i = 0; i < CLASSES; ++i) {
        detail.share[kKindOfClass[i]] += mixture.share[i];
        detail.amount[kKindOfClass[i]] += mixture.share[i] * u_.classes[i].noise.x;
    }
    return detail;
}

/// What the extinction is multiplied by at a point. The noise is that of the nearest texel to a
/// place that is jittered within one texel: on average this is linear interpolation, at an eighth
/// of its fetches.
float detailAt(vec3 positionM, vec3 jitter, Detail detail) {
    float factor = 0.0;
    for (int k = 0; k < KINDS; ++k) {
        vec4 kind = u_.classes[kClassOfKind[k]].noise;
        vec3 at = (positionM + u_.moved.xyz) * kind.ywy + jitter;
        at.z = 0.5 * (fract(at.z) + kind.z);
        float noise = textureLod(t_noise, at, 0.0).r / kDetailMean - 1.0;
        factor += max(0.0, detail.share[k] + detail.amount[k] * noise);
    }
    return factor;
}
#endif
