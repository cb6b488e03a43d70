// packed_sample.glsl: reading the medium of the march at a point: extinction from one texture,
// what it is a mixture of from another at half the resolution.
#pragma once
#include "../medium/bricks.glsl"
#include "../shared/frame.glsl"
#include "../shared/march_layout.glsl"

// r: 1/m, g: share of sunlight.
layout(binding = kMarchExtinctionUnit) uniform sampler3D t_extinction;
// r: skylight, gba: classes 0 to 2.
layout(binding = kMarchMixture0Unit) uniform sampler3D t_mixture0;
#if MIXTURE_TEXTURES > 1
layout(binding = kMarchMixture1Unit) uniform sampler3D t_mixture1;  // rgb: classes 3 to 5
#endif
#if FULL
// Half of how thick a voxel of light is.
layout(binding = kMarchThicknessUnit) uniform sampler3D t_thickness;
#endif

struct Mixture {
    float skylight;
    float share[CLASSES];  ///< of the extinction; they add to 1
};

Mixture mixtureAt(vec3 positionM) {
    vec3 at = positionM / u_.mixtureExtentM.xyz;
    vec4 first = textureLod(t_mixture0, at, 0.0);
    float stored[2 * kClassesBesideSkylight] = float[](first.g, first.b, first.a, 0.0, 0.0, 0.0);
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

struct MediumSample {
    float extinctionPerM[CLASSES];
};

/// As the light pass reads it.
MediumSample sampleMedium(vec3 positionM) {
    float extinctionPerM = textureLod(t_extinction, positionM / u_.gridExtentM.xyz, 0.0).r;
    MediumSample s;
#if CLASSES > 1
    Mixture mixture = mixtureAt(positionM);
    for (int i = 0; i < CLASSES; ++i) s.extinctionPerM[i] = extinctionPerM * mixture.share[i];
#else
    s.extinctionPerM[0] = extinctionPerM;
#endif
    return s;
}

#if FULL
/// Place of a point in textures of the voxels of light.
vec3 lightVoxelAt(vec3 positionM) {
    return repeated(positionM) * u_.lightPerM.xyz + u_.lightOffset.xyz;
}

/// Place of a point in the texture of their light.
vec3 sourceAt(vec3 positionM) {
    return repeated(positionM) * u_.sourcePerM.xyz + u_.sourceOffset.xyz;
}

/// How thick the voxels of light are around a point: 0 thin, 1 thick, 2 very thick.
float thicknessAt(vec3 positionM) {
    return 2.0 * textureLod(t_thickness, lightVoxelAt(positionM), 0.0).r;
}

/// Share of the extinction of a class that is left where light scattered forward counts as not
/// scattered. docs/transport.md
float scaledShare(int index, float thickness) {
    vec4 forward = u_.classes[index].forward;
    return 1.0 - mix(mix(forward.x, forward.y, min(thickness, 1.0)), forward.z,
                     max(thickness - 1.0, 0.0));
}
#endif
