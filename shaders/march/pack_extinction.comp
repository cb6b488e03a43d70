// pack_extinction.comp: the extinction of all that is visible, one work group a block that may hold
// anything. The second channel, sunlight, is left as it is.
//
// DETAIL: each species times its detail, down to the size of a voxel: the level of the noise whose
// texels are as large.
#version 450 core
#include "../shared/march_layout.glsl"
layout(local_size_x = kBlockVoxels, local_size_y = kBlockVoxels, local_size_z = 1) in;
#include "../lib/noise.glsl"
#include "../shared/groups_layout.glsl"

layout(binding = kHeldUnit) uniform sampler3D t_held[SPECIES];  // those that are visible
layout(rg16f, binding = kMarchExtinctionImage) uniform image3D io_extinction;
layout(std430, binding = kMarchBlocksBuffer) readonly buffer Blocks {
    ivec4 blocks[];
};
layout(location = kFirstGroupLocation) uniform int firstGroup;
layout(location = kPackExtinctionPerTexelLocation) uniform float extinctionPerTexel[SPECIES];
#if DETAIL
// A tile of billow, and of wisp upon it.
layout(binding = kBesideHeldUnit) uniform sampler3D t_noise;
layout(location = kPackAmountLocation) uniform float amount[SPECIES];  // of each species' detail
// Of each scale and character of detail.
layout(location = kPackTexelsPerMLocation) uniform vec3 noiseTexelsPerM[KINDS];
layout(location = kPackCharacterLocation) uniform float character[KINDS];  // 0 billow, 1 wisp
layout(location = kPackVoxelLocation) uniform vec3 voxelM;
layout(location = kPackMovedLocation) uniform vec3 movedM;  // FrameBlock::moved
const int kKindOfSpecies[SPECIES] = KIND_OF_SPECIES;

float noiseOf(int kind, vec3 positionM) {
    float texels = noiseTexelsPerM[kind].x * min(min(voxelM.x, voxelM.y), voxelM.z);  // a voxel
    int level = clamp(int(round(log2(max(texels, 1.0)))), 0, kNoiseLevels - 1);
    ivec3 at = ivec3(floor(positionM * noiseTexelsPerM[kind])) & (kNoiseSize - 1);
    at.z += int(character[kind]) * kNoiseSize;
    return texelFetch(t_noise, at >> level, level).r;
}
#endif

float extinctionAt(ivec3 voxel) {
#if DETAIL
    float noise[KINDS];
    for (int k = 0; k < KINDS; ++k) noise[k] = noiseOf(k, (vec3(voxel) + 0.5) * voxelM + movedM);
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
    ivec3 voxel =
        kBlockVoxels * blocks[firstGroup + int(gl_WorkGroupID.x)].xyz + ivec3(gl_LocalInvocationID);
    ivec3 size = imageSize(io_extinction);
    for (int z = 0; z < kBlockVoxels; ++z, ++voxel.z) {
        float extinctionPerM = extinctionAt(voxel);
        if (all(lessThan(voxel, size))) {
            float light = imageLoad(io_extinction, voxel).g;
            imageStore(io_extinction, voxel, vec4(extinctionPerM, light, 0.0, 0.0));
        }
    }
}
