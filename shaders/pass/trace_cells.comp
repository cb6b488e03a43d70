// trace_cells.comp: the largest extinction that a sample in each cell can have; cells are those of
// trace_medium.glsl.
#version 450 core
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

layout(binding = 0) uniform sampler3D t_medium0;
#if CLASS_TEXTURES > 1
layout(binding = 1) uniform sampler3D t_medium1;
#endif
layout(r32f, binding = 0) writeonly uniform image3D o_bound;
layout(location = 0) uniform int cellVoxels;          // a side
layout(location = 1) uniform float largestDetail[8];  // factor of each class

float extinctionAt(ivec3 voxel) {
    vec4 first = texelFetch(t_medium0, voxel, 0);
    float sum = 0.0;
    for (int i = 0; i < min(CLASSES, 4); ++i) sum += largestDetail[i] * first[i];
#if CLASS_TEXTURES > 1
    vec4 second = texelFetch(t_medium1, voxel, 0);
    for (int i = 4; i < CLASSES; ++i) sum += largestDetail[i] * second[i - 4];
#endif
    return sum;
}

void main() {
    ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(cell, imageSize(o_bound)))) return;
    ivec3 lower = max(cell * cellVoxels - 1, ivec3(0));
    ivec3 upper = min((cell + 1) * cellVoxels, textureSize(t_medium0, 0));
    float largest = 0.0;
    for (int z = lower.z; z < upper.z; ++z) {
        for (int y = lower.y; y < upper.y; ++y) {
            for (int x = lower.x; x < upper.x; ++x) {
                largest = max(largest, extinctionAt(ivec3(x, y, z)));
            }
        }
    }
    imageStore(o_bound, cell, vec4(largest, 0.0, 0.0, 0.0));
}
