// sun_shown.comp: how much of the sun's disc the medium and the ground let the eye see: the mean
// of a few rays, in coarse steps.
#version 450 core
#include "../shared/medium_layout.glsl"
layout(local_size_x = kSunShownLanes) in;
#include "../lib/directions.glsl"
#include "../lib/sun_disc.glsl"
#include "ray_in_box.glsl"
#if PACKED
layout(binding = kMedium0Unit) uniform sampler3D t_extinction;  // of the march
#else
#include "sample.glsl"
#include "total_extinction.glsl"
#endif

layout(r32f, binding = kSunShownImage) writeonly uniform image2D o_shown;

const int kRays = 8, kParts = kSunShownLanes / kRays, kSteps = 32;  // of each part

shared float depths_[kSunShownLanes];

float extinctionPerM(vec3 positionM) {
#if PACKED
    return textureLod(t_extinction, positionM / u_.gridExtentM.xyz, 0.0).r;
#else
    return totalExtinctionPerM(sampleMedium(positionM));
#endif
}

/// Around the middle, at the distance that half of the disc is within.
vec3 towards(int number) {
    float versine = number == 0 ? 0.0 : 0.25 * kSunRadius * kSunRadius;
    return directionAround(u_.disc.xyz, versine, float(number) / float(kRays - 1));
}

float depthOf(Ray ray, int part) {
    vec2 insideM = insideBoxM(ray);
    if (insideM.x >= insideM.y) return 0.0;
    float stepM = (insideM.y - insideM.x) / float(kParts * kSteps);
    float depth = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        float atM = insideM.x + (float(i * kParts + part) + 0.5) * stepM;
        depth += stepM * extinctionPerM(pointAlong(ray, atM));
    }
    return depth;
}

void main() {
    int lane = int(gl_LocalInvocationIndex);
    Ray ray = Ray(u_.eyeM.xyz, towards(lane / kParts));
    depths_[lane] = groundDistanceM(ray) > 0.0 ? 1e3 : depthOf(ray, lane % kParts);
    barrier();
    if (lane > 0) return;
    float shown = 0.0;
    for (int r = 0; r < kRays; ++r) {
        float depth = 0.0;
        for (int i = 0; i < kParts; ++i) depth += depths_[r * kParts + i];
        shown += exp(-depth) / float(kRays);
    }
    imageStore(o_shown, ivec2(0), vec4(shown));
}
