// diffuse.glsl: what voxels of light send towards the eye by scattering diffuse light. Once for
// each node where the domain is seen once; where it repeats, the eye stands in another direction
// from each repeat, and a ray takes the moments of the nodes. docs/transport.md
#pragma once
#include "../lib/harmonics.glsl"
#include "../sky/air.glsl"
#include "packed_sample.glsl"
#include "sent.glsl"

#if FULL
// Of source_to_eye.comp.
layout(binding = kMarchSourceUnit) uniform sampler3D t_source;

#if PERIODIC
vec4 towardsEye_[kMomentLayers];  // what a ray makes of four moments each

/// `dir`: of a ray from the eye.
void lookUpDiffuse(vec3 dir) {
    vec3 sunTravel = -u_.towardsSun.xyz;
    DirectionHarmonics y = directionHarmonics(-dir, sunTravel);
    float of[4 * kMomentLayers];
    for (int i = 0; i < 4 * kMomentLayers; ++i) of[i] = 0.0;
    for (int q = 0; q < kSunMoments; ++q) of[q] = y.value[q];
    for (int q = 0; q < 2 * kSkyMoments; ++q) of[kFirstSkyMoment + q] = y.value[q % kSkyMoments];
    float cosTheta = dot(-dir, sunTravel);
    float before = 0.0;
    float legendre = 1.0;
    for (int l = 0; l < kBalancedDegrees; ++l) {
        float n = float(l);
        of[kFirstBalancedMoment + l] = (2.0 * n + 1.0) * legendre;
        float next = ((2.0 * n + 1.0) * cosTheta * legendre - n * before) / (n + 1.0);
        before = legendre;
        legendre = next;
    }
    for (int j = 0; j < kMomentLayers; ++j) {
        towardsEye_[j] = vec4(of[4 * j], of[4 * j + 1], of[4 * j + 2], of[4 * j + 3]);
    }
}

/// What is sent along the ray from a point, as source_to_eye.comp has it where nothing repeats;
/// `sun`: sunAt() there.
vec4 sentAlongRay(vec3 positionM, vec3 sun) {
    const int kLayers = BALANCED == 1 ? kMomentLayers : kMomentLayersUnbalanced;
    vec3 size = vec3(textureSize(t_source, 0));
    float layer = size.z / float(kLayers);
    vec3 at = sourceAt(positionM);
    at.z = clamp(at.z * layer, 0.5, layer - 0.5) / size.z;
    float of[4 * kMomentLayers];
    for (int j = 0; j < kLayers; ++j) {
        vec3 place = vec3(at.xy, at.z + float(j) / float(kLayers));
        vec4 four = towardsEye_[j] * textureLod(t_source, place, 0.0);
        for (int k = 0; k < 4; ++k) of[4 * j + k] = four[k];
    }
    float bySun = 0.0, bySky[2] = float[](0.0, 0.0), held = 0.0;
    for (int q = 0; q < kSunMoments; ++q) bySun += of[q];
    for (int q = 0; q < 2 * kSkyMoments; ++q) bySky[q / kSkyMoments] += of[kFirstSkyMoment + q];
#if BALANCED
    for (int l = 0; l < kBalancedDegrees; ++l) held += of[kFirstBalancedMoment + l];
#endif
    float altitude = altitudeM(positionM);
    return vec4(sunSent(bySun, sun) + skySent(bySky[0], bySky[1], altitude), held);
}
#endif
#endif
