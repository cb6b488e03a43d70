// brick_maximum.comp: as brick_maximum.comp, of the march's medium: one work group a block
// that may hold anything, one invocation a brick of it. Other bricks are left at 0.
#version 450 core
#include "../shared/groups_layout.glsl"
#include "../shared/march_layout.glsl"

const int kBricks = kBlockVoxels / kBrickVoxels;  // along the edge of a block
layout(local_size_x = kBricks, local_size_y = kBricks, local_size_z = kBricks) in;

layout(binding = kMarchExtinctionUnit) uniform sampler3D t_extinction;
layout(r32f, binding = kBrickMaximumImage) writeonly uniform image3D o_maximum;
layout(std430, binding = kMarchBlocksBuffer) readonly buffer Blocks {
    ivec4 blocks[];
};
layout(location = kFirstGroupLocation) uniform int firstGroup;

void main() {
    ivec3 brick =
        kBricks * blocks[firstGroup + int(gl_WorkGroupID.x)].xyz + ivec3(gl_LocalInvocationID);
    ivec3 last = textureSize(t_extinction, 0) - 1;
    ivec3 lower = brick * kBrickVoxels - 1;
    float largest = 0.0;
    for (int z = 0; z < kBrickVoxels + 2; ++z) {
        for (int y = 0; y < kBrickVoxels + 2; ++y) {
            for (int x = 0; x < kBrickVoxels + 2; ++x) {
                ivec3 voxel = lower + ivec3(x, y, z);
#if PERIODIC
                voxel.xy = (voxel.xy + last.xy + 1) % (last.xy + 1);
#endif
                voxel = clamp(voxel, ivec3(0), last);
                largest = max(largest, texelFetch(t_extinction, voxel, 0).r);
            }
        }
    }
    if (all(lessThan(brick, imageSize(o_maximum)))) {
        imageStore(o_maximum, brick, vec4(largest, 0.0, 0.0, 0.0));
    }
}
