// brick_maximum.comp: the largest extinction that trilinear interpolation can give inside each
// brick.
//
// A sample in a brick reads voxels of the brick and one more on every side.
#version 450 core
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "../shared/medium_layout.glsl"

layout(binding = kMedium0Unit) uniform sampler3D t_medium0;
#if CLASS_TEXTURES > 1
layout(binding = kMedium1Unit) uniform sampler3D t_medium1;
#endif
layout(r32f, binding = kBrickMaximumImage) writeonly uniform image3D o_maximum;

float extinctionAt(ivec3 voxel) {
    vec4 first = texelFetch(t_medium0, voxel, 0);
#if CLASS_TEXTURES > 1
    return dot(first, vec4(1.0)) + dot(texelFetch(t_medium1, voxel, 0).xyz, vec3(1.0));
#else
    return first.x + first.y + first.z;
#endif
}

void main() {
    ivec3 brick = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(brick, imageSize(o_maximum)))) return;
    ivec3 size = textureSize(t_medium0, 0);
    ivec3 lower = brick * kBrickVoxels - 1;
    ivec3 upper = (brick + 1) * kBrickVoxels + 1;
    lower.z = max(lower.z, 0);
    upper.z = min(upper.z, size.z);
#if !PERIODIC
    lower.xy = max(lower.xy, ivec2(0));
    upper.xy = min(upper.xy, size.xy);
#endif
    float largest = 0.0;
    for (int z = lower.z; z < upper.z; ++z) {
        for (int y = lower.y; y < upper.y; ++y) {
            for (int x = lower.x; x < upper.x; ++x) {
                largest = max(largest, extinctionAt((ivec3(x, y, z) + size) % size));
            }
        }
    }
    imageStore(o_maximum, brick, vec4(largest, 0.0, 0.0, 0.0));
}
