// pack_extinction.comp: the extinction of all that is visible, one work group a block that may hold
// anything. The second channel, sunlight, is left as it is.
//
// DETAIL: each species times its detail, down to the size of a voxel: the level of the noise whose
// texels are as large.
#version 450 core
layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
#include "../lib/noise.glsl"

layout(binding = 0) uniform sampler3D t_held[SPECIES];  // those that are visible
layout(rg16f, binding = 0) uniform image3D io_extinction;
layout(std430, binding = 0) readonly buffer Blocks {
    ivec4 blocks[];
};
layout(location = 20) uniform int firstGroup;
layout(location = 0) uniform float extinctionPerTexel[SPECIES];
#if DETAIL
layout(binding = 6) uniform sampler3D t_noise;        // a tile of billow, and of wisp upon it
layout(location = 30) uniform float amount[SPECIES];  // of each species' detail
layout(location = 36) uniform
    float noiseTexelsPerM[KINDS];                      // of each scale and character of detail
layout(location = 42) uniform float character[KINDS];  // 0 billow, 1 wisp
layout(location = 48) uniform vec3 voxelM;
const int kKindOfSpecies[SPECIES] = KIND_OF_SPECIES;

float noiseOf(int kind, vec3 positionM) {
    float texels = noiseTexelsPerM[kind] * min(min(voxelM.x, voxelM.y), voxelM.z);  // a voxel
    int level = clamp(int(round(log2(max(texels, 1.0)))), 0, NOISE_LEVELS - 1);
    ivec3 at = ivec3(floor(positionM * noiseTexelsPerM[kind])) & (NOISE_SIZE - 1);
    at.z += int(character[kind]) * NOISE_SIZE;
    return texelFetch(t_noise, at >> level, level).r;
}
#endif

float extinctionAt(ivec3 voxel) {
#if DETAIL
    float noise[KINDS];
    for (int k = 0; k < KINDS; ++k) noise[k] = noiseOf(k, (vec3(voxel) + 0.5) * voxelM);
#endif
    float extinctionPerM = 0.0;
    for (int s = 0; s < SPECIES; ++s) {
        float e = extinctionPerTexel[s] * texelFetch(t_held[s], voxel, 0).r;
#if DETAIL
        e *= detailFactor(noise[kKindOfSpecies[s]], amount[s]);
#endif
        extinctionPerM += e;
    }
    return extinctionPerM;
}

void main() {
    ivec3 voxel = 8 * blocks[firstGroup + int(gl_WorkGroupID.x)].xyz + ivec3(gl_LocalInvocationID);
    ivec3 size = imageSize(io_extinction);
    for (int z = 0; z < 8; ++z, ++voxel.z) {
        float extinctionPerM = extinctionAt(voxel);
        if (all(lessThan(voxel, size))) {
            float light = imageLoad(io_extinction, voxel).g;
            imageStore(io_extinction, voxel, vec4(extinctionPerM, light, 0.0, 0.0));
        }
    }
}
