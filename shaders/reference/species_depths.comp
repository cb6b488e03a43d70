// species_depths.comp: optical depth of each species along the ray through each pixel's middle, by
// the midpoints of short steps.
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "../lib/noise.glsl"
#include "../medium/ray_in_box.glsl"
#include "../shared/reference_layout.glsl"

layout(binding = kHeldUnit) uniform sampler3D t_held[kSpeciesCount];  // kg/m³ or 1/m
#if NOISE
layout(binding = kBesideHeldUnit) uniform sampler3D t_noise;  // r: billow, g: wisp
#endif
layout(std430, binding = kDepthsBuffer) writeonly buffer Depths {
    float depths_[];  // species after species
};
// 0 when absent.
layout(location = kExtinctionPerHeldLocation) uniform float extinctionPerHeld[kSpeciesCount];
layout(location = kClassOfLocation) uniform int classOf[kSpeciesCount];
layout(location = kDepthsStepLocation) uniform float longestStepM;

float detailOf(int index, vec3 positionM) {
#if NOISE
    vec4 noise = u_.classes[index].noise;
    vec2 texel = textureLod(t_noise, (positionM + u_.moved.xyz) * noise.y, 0.0).rg;
    return detailFactor(noise.z < 0.5 ? texel.r : texel.g, noise.x);
#else
    return 1.0;
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, u_.image.xy))) return;
    Ray ray = rayThrough(pixel);
    vec2 inside = partInBoxM(ray, vec3(0.0), u_.gridExtentM.xyz);
    float lengthM = max(0.0, inside.y - max(inside.x, 0.0));
    int steps = int(ceil(lengthM / longestStepM));
    float stepM = lengthM / float(max(steps, 1));
    float depth[kSpeciesCount];
    for (int s = 0; s < kSpeciesCount; ++s) depth[s] = 0.0;
    for (int i = 0; i < steps; ++i) {
        vec3 positionM = pointAlong(ray, max(inside.x, 0.0) + (float(i) + 0.5) * stepM);
        for (int s = 0; s < kSpeciesCount; ++s) {
            if (classOf[s] < 0) continue;
            float held = textureLod(t_held[s], positionM / u_.gridExtentM.xyz, 0.0).r;
            depth[s] += extinctionPerHeld[s] * held * stepM * detailOf(classOf[s], positionM);
        }
    }
    int count = u_.image.x * u_.image.y;
    for (int s = 0; s < kSpeciesCount; ++s) {
        depths_[s * count + pixel.y * u_.image.x + pixel.x] = depth[s];
    }
}
