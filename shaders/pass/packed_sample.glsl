// packed_sample.glsl: reading the medium of the march at a point: extinction from one texture,
// what it is a mixture of from another at half the resolution.
#pragma once
#include "../lib/noise.glsl"
#include "bricks.glsl"
#include "frame.glsl"

layout(binding = 0) uniform sampler3D t_extinction;  // r: 1/m, g: share of sunlight
layout(binding = 1) uniform sampler3D t_mixture0;    // r: skylight, gba: classes 0 to 2
#if MIXTURE_TEXTURES > 1
layout(binding = 5) uniform sampler3D t_mixture1;  // rgb: classes 3 to 5
#endif
#if NOISE
layout(binding = 3) uniform sampler3D t_noise;  // a tile of billow, and of wisp upon it; nearest
#endif

struct Mixture {
    float skylight;
    float share[CLASSES];  ///< of the extinction; they add to 1
};

Mixture mixtureAt(vec3 positionM) {
    vec3 at = positionM / u_.mixtureExtentM.xyz;
    vec4 first = textureLod(t_mixture0, at, 0.0);
    float stored[6] = float[6](first.g, first.b, first.a, 0.0, 0.0, 0.0);
#if MIXTURE_TEXTURES > 1
    vec4 second = textureLod(t_mixture1, at, 0.0);
    stored[3] = second.r;
    stored[4] = second.g;
    stored[5] = second.b;
#endif
    float sum = 1e-6;
    for (int i = 0; i < CLASSES; ++i) sum += stored[i];
    Mixture mixture;
    mixture.skylight = first.r;
    for (int i = 0; i < CLASSES; ++i) mixture.share[i] = stored[i] / sum;
    return mixture;
}

#if NOISE
/// What the extinction is multiplied by at a point: the detail of one class, drawn by `u` with the
/// classes' shares, from the nearest texel to a place that is jittered within one texel by
/// `random`. On average this is every class's detail, interpolated linearly, by its share. Detail
/// finer than half of `stepM` could not be followed and is left out.
float detailAt(vec3 positionM, float stepM, float random, float u, Mixture mixture) {
    vec4 noise = u_.classes[0].noise;
    float edge = mixture.share[0];
    for (int i = 1; i < CLASSES; ++i) {
        if (u >= edge) noise = u_.classes[i].noise;
        edge += mixture.share[i];
    }
    float texels = max(1.0, 0.5 * NOISE_SIZE * noise.y * stepM);  // in half a step
    vec3 jitter = (fract(random * vec3(5.0, 37.0, 91.0)) - 0.5) * texels / NOISE_SIZE;
    vec3 at = positionM * noise.y + jitter;
    at.z = 0.5 * (fract(at.z) + noise.z);
    return detailFactor(textureLod(t_noise, at, log2(texels)).r, noise.x);
}
#endif

struct MediumSample {
    float extinctionPerM[CLASSES];
};

/// As the light pass reads it.
MediumSample sampleMedium(vec3 positionM, float random) {
    float extinctionPerM = textureLod(t_extinction, positionM / u_.gridExtentM.xyz, 0.0).r;
    MediumSample s;
#if CLASSES > 1
    Mixture mixture = mixtureAt(positionM);
#else
    Mixture mixture = Mixture(0.0, float[1](1.0));
#endif
#if NOISE
    extinctionPerM *= detailAt(positionM, u_.towardsSun.w, random, fract(19.0 * random), mixture);
#endif
    for (int i = 0; i < CLASSES; ++i) s.extinctionPerM[i] = extinctionPerM * mixture.share[i];
    return s;
}

float totalExtinctionPerM(MediumSample s) {
    float sum = 0.0;
    for (int i = 0; i < CLASSES; ++i) sum += s.extinctionPerM[i];
    return sum;
}
