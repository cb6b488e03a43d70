// pack_extinction.comp: the extinction of all that is visible, one work group a block that may hold
// anything. The second channel, sunlight, is filled in later.
#version 450 core
layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;

const int kSpeciesCount = 6;
layout(binding = 0) uniform sampler3D t_held[kSpeciesCount];
layout(rg16f, binding = 0) writeonly uniform image3D o_extinction;
layout(std430, binding = 0) readonly buffer Blocks {
    ivec4 blocks[];
};
layout(location = 20) uniform int firstGroup;
layout(location = 0) uniform float extinctionPerTexel[kSpeciesCount];  // 0 when absent

void main() {
    ivec3 voxel = 8 * blocks[firstGroup + int(gl_WorkGroupID.x)].xyz + ivec3(gl_LocalInvocationID);
    ivec3 size = imageSize(o_extinction);
    for (int z = 0; z < 8; ++z, ++voxel.z) {
        float extinctionPerM = 0.0;
        for (int s = 0; s < kSpeciesCount; ++s) {
            extinctionPerM += extinctionPerTexel[s] * texelFetch(t_held[s], voxel, 0).r;
        }
        if (all(lessThan(voxel, size)))
            imageStore(o_extinction, voxel, vec4(extinctionPerM, 0, 0, 0));
    }
}
