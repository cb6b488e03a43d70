// sample.glsl: what the slicing passes share: reading the medium at a point, with its
// detail.
#pragma once
#include "../lib/noise.glsl"
#include "../shared/frame.glsl"
#include "../shared/medium_layout.glsl"
#include "bricks.glsl"

layout(binding = kMedium0Unit) uniform sampler3D t_medium0;
#if CLASS_TEXTURES > 1
layout(binding = kMedium1Unit) uniform sampler3D t_medium1;
#endif
#if NOISE
layout(binding = kNoiseUnit) uniform sampler3D t_noise;  // r: billow, g: wisp
#endif

struct MediumSample {
    float extinctionPerM[4 * CLASS_TEXTURES];  // the last channel is the skylight
};

#if NOISE
float detail(vec3 positionM, int index) {
    vec4 noise = u_.classes[index].noise;
    vec2 texel = textureLod(t_noise, (positionM + u_.moved.xyz) * noise.ywy, 0.0).rg;
    return detailFactor(noise.z < 0.5 ? texel.r : texel.g, noise.x);
}
#endif

/// Extinction of each class at a point of grid space.
MediumSample sampleMedium(vec3 positionM) {
    MediumSample s;
    vec3 at = positionM / u_.gridExtentM.xyz;
    vec4 first = textureLod(t_medium0, at, 0.0);
    for (int i = 0; i < 4; ++i) s.extinctionPerM[i] = first[i];
#if CLASS_TEXTURES > 1
    vec4 second = textureLod(t_medium1, at, 0.0);
    for (int i = 0; i < 4; ++i) s.extinctionPerM[4 + i] = second[i];
#endif
#if NOISE
    for (int i = 0; i < CLASSES; ++i) {
        if (u_.classes[i].noise.x > 0.0 && s.extinctionPerM[i] > 0.0) {
            s.extinctionPerM[i] *= detail(positionM, i);
        }
    }
#endif
    return s;
}

float skylightOf(MediumSample s) {
    return s.extinctionPerM[4 * CLASS_TEXTURES - 1];
}
