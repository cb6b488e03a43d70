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
    vec2 texel = textureLod(t_noise, (positionM + u_.moved.xyz) * noise.ywy, 0.0).rg;
    return detailFactor(noise.z < 0.5 ? texel.r : texel.g, noise.x);
#else
    return 1.0;
#endif
}

/// Interpolated as the medium is, across the sides of a domain that repeats too.
float heldAt(int s, vec3 positionM) {
#if PERIODIC
    ivec3 size = textureSize(t_held[s], 0);
    vec3 at = repeated(positionM) / u_.gridExtentM.xyz * vec3(size) - 0.5;
    vec3 upper = at - floor(at);
    float held = 0.0;
    for (int k = 0; k < 8; ++k) {
        ivec3 corner = ivec3(k & 1, k >> 1 & 1, k >> 2);
        ivec3 voxel = (ivec3(floor(at)) + corner + size) % size;
        voxel.z = clamp(int(floor(at.z)) + corner.z, 0, size.z - 1);
        vec3 share = mix(1.0 - upper, upper, vec3(corner));
        held += share.x * share.y * share.z * texelFetch(t_held[s], voxel, 0).r;
    }
    return held;
#else
    return textureLod(t_held[s], positionM / u_.gridExtentM.xyz, 0.0).r;
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, u_.image.xy))) return;
    Ray ray = rayThrough(pixel);
    vec2 inside = partSeenM(ray, vec3(0.0), u_.gridExtentM.xyz);
    float lengthM = max(0.0, inside.y - max(inside.x, 0.0));
    int steps = int(ceil(lengthM / longestStepM));
    float stepM = lengthM / float(max(steps, 1));
    float depth[kSpeciesCount];
    for (int s = 0; s < kSpeciesCount; ++s) depth[s] = 0.0;
    for (int i = 0; i < steps; ++i) {
        vec3 positionM = pointAlong(ray, max(inside.x, 0.0) + (float(i) + 0.5) * stepM);
        for (int s = 0; s < kSpeciesCount; ++s) {
            if (classOf[s] < 0) continue;
            depth[s] += extinctionPerHeld[s] * heldAt(s, positionM) * stepM *
                        detailOf(classOf[s], positionM);
        }
    }
    int count = u_.image.x * u_.image.y;
    for (int s = 0; s < kSpeciesCount; ++s) {
        depths_[s * count + pixel.y * u_.image.x + pixel.x] = depth[s];
    }
}
