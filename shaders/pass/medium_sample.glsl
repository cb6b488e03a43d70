// medium_sample.glsl: what the slicing passes share: reading the medium at a point, with its
// detail, and skipping what is empty.
#pragma once
#include "../lib/noise.glsl"
#include "../lib/ray_box.glsl"
#include "frame.glsl"

layout(binding = 0) uniform sampler3D t_medium0;
#if CLASS_TEXTURES > 1
layout(binding = 1) uniform sampler3D t_medium1;
#endif
layout(binding = 2) uniform usampler3D
    t_emptiness;  // distance to the nearest occupied brick, in bricks
#if NOISE
layout(binding = 3) uniform sampler3D t_noise;  // r: billow, g: wisp
#endif

struct MediumSample {
    float extinctionPerM[4 * CLASS_TEXTURES];  // the last channel is the skylight
};

#if NOISE
float detail(vec3 positionM, int index) {
    vec4 noise = u_.classes[index].noise;
    vec2 texel = textureLod(t_noise, positionM * noise.y, 0.0).rg;
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

float totalExtinctionPerM(MediumSample s) {
    float sum = 0.0;
    for (int i = 0; i < CLASSES; ++i) sum += s.extinctionPerM[i];
    return sum;
}

float skylightOf(MediumSample s) {
    return s.extinctionPerM[4 * CLASS_TEXTURES - 1];
}

/// Bricks around the point that are certainly empty: 0 in an occupied brick.
int emptiness(vec3 positionM) {
    ivec3 brick =
        clamp(ivec3(positionM / u_.brickM.xyz), ivec3(0), textureSize(t_emptiness, 0) - 1);
    return int(texelFetch(t_emptiness, brick, 0).r);
}

/// Distance along the unit `dir` to the wall of the empty block of `bricks` around the point.
float emptyDistanceM(vec3 positionM, vec3 dir, int bricks) {
    vec3 brick = floor(positionM / u_.brickM.xyz);
    vec3 ahead = mix(brick - float(bricks - 1), brick + float(bricks),
                     greaterThan(divisible(dir), vec3(0.0)));
    vec3 distance = (ahead * u_.brickM.xyz - positionM) / divisible(dir);
    return min(min(distance.x, distance.y), distance.z);
}
