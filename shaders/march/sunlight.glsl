// sunlight.glsl: sunlight that is scattered once, along one ray.
#pragma once
#include "../medium/phases.glsl"
#include "../shared/frame.glsl"
#include "packed_sample.glsl"

const float kLog2E = 1.44269504;
#if FULL
const int kSunlit = CLASSES * kPhaseRows;
#else
const int kSunlit = CLASSES;
#endif
vec3 sunlit_[kSunlit];  // by each class and, with FULL, row of it, along the ray

void lookUpSunlight(vec3 dir, bool peaks) {
    const int kRows = kSunlit / CLASSES;
    for (int i = 0; i < kSunlit; ++i) {
        if (peaks || i % kRows == 0) sunlit_[i] = sunlitBy(i / kRows, i, dir);
    }
}

#if FULL
/// What the mixture of a run does with light, per unit of scaled optical depth.
struct Optics {
    float kept;     ///< scaled extinction over extinction
    float forward;  ///< scattering into the peak, which does not count
    vec3 once;      ///< sunlight scattered once
    vec3 peak[3];   ///< of it, what is forward; and scattered forward twice, and more often
    vec3 colour;    ///< of what is scattered more often
};

/// `peaks`: what is forward is wanted.
Optics opticsOf(Mixture mixture, float thickness, bool peaks) {
    Optics optics = Optics(0.0, 0.0, vec3(0.0), vec3[](vec3(0.0), vec3(0.0), vec3(0.0)), vec3(0.0));
    vec3 near = max(1.0 - abs(thickness - vec3(0.0, 1.0, 2.0)), 0.0);
    for (int i = 0; i < CLASSES; ++i) {
        float share = mixture.share[i];
        int row = kPhaseRows * i;
        optics.kept += share * scaledShare(i, thickness);
        optics.once += share * sunlit_[row];
        optics.colour += share * u_.classes[i].colourAlbedo.rgb;
        if (!peaks) continue;
        optics.forward += share * dot(near, u_.classes[i].forward.xyz);
        for (int k = 0; k < kPeakTimes; ++k) {
            int peak = row + 1 + k;
            optics.peak[k] +=
                share * (near.x * sunlit_[peak] + near.y * sunlit_[peak + kPeakTimes] +
                         near.z * sunlit_[peak + 2 * kPeakTimes]);
        }
    }
    float perKept = 1.0 / max(optics.kept, 1e-6);
    optics.forward *= perKept;
    optics.once *= perKept;
    for (int k = 0; k < 3; ++k) optics.peak[k] *= perKept;
    optics.colour /= max(dot(optics.colour, kLuminance), 1e-6);
    return optics;
}

/// Sunlight scattered once. Light that goes forward m times on its way, `forward` times in the
/// mean, would be counted at each of them: it is taken at an m-th, and as wide as m times make it.
vec3 scatteredOnce(Optics optics, float forward) {
    float never = exp2(-kLog2E * forward);
    float twice = 0.5 * forward * never;
    float shares = forward > 1e-3 ? (1.0 - never) / forward : 1.0 - 0.5 * forward;
    return optics.once + (never - 1.0) * optics.peak[0] + twice * optics.peak[1] +
           max(shares - never - twice, 0.0) * optics.peak[2];
}
#endif
